#include <kerf/cut.h>
#include <kerf/io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <set>
#include <string>
#include <utility>

#include "common/support/random.h"
#include "viewer/render/frame_target.h"
#include "viewer/render/fruit_looks.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/inspection_pass.h"
#include "viewer/render/pieces_on_stage.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/support/stages.h"

namespace kerf::test {

namespace {

using render::DrawnFragment;
using render::DrawnObject;
using render::DrawOptions;
using render::Picture;
using render::PixelFacts;

const std::vector<std::string> kFruit{"watermelon", "apple", "orange", "lemon",  "kiwi",   "banana", "coconut",
                                      "pineapple",  "bomb",  "freeze", "frenzy", "double", "hammer", "frozen"};

Mesh fruit(const std::string& name)
{
    return value_of(read_mesh((KERF_DATA_DIR "/fruit/" + name + ".glb").c_str()));
}

/// Towards the eye and the light, somewhat aside; and 60 degrees off the eye, away from the light.
const glm::vec3 kBright = glm::normalize(glm::vec3(0.2f, 0.25f, 1.0f)), kShady(0.5f, -0.7071f, 0.5f);

/// Turns the direction `from` towards `to`.
glm::mat4 facing(const glm::vec3& from, const glm::vec3& to = kBright)
{
    const glm::vec3 axis = glm::cross(from, to);
    const float sine = glm::length(axis);
    if (sine < 1e-4f) return glm::mat4(1.0f);
    return glm::rotate(glm::mat4(1.0f), std::atan2(sine, glm::dot(from, to)), axis / sine);
}

/// The pieces behind a plane, their caps turned towards `to`.
std::vector<StagedPiece> opened(const std::string& back_end, const Mesh& mesh, const Plane& plane,
                                const glm::vec3& to = kBright)
{
    const Box box = mesh.bounds();
    const auto radius = static_cast<float>(sim::radius_of(box));
    Cut result = cut(object_of(mesh, back_end), plane);
    std::vector<StagedPiece> pieces;
    glm::mat4 model = glm::scale(facing(glm::vec3(plane.normal()), to), glm::vec3(1.0f / radius));
    model = glm::translate(model, -glm::vec3(sim::centre_of(box)));
    if (Object* const piece = result.one(Side::negative))
        pieces.push_back({std::move(*piece), model, 0.5f / radius, plane, mesh.is_closed()});
    return pieces;
}

/// Through the flesh, near its middle, in any direction.
Plane any_plane(core::Random& random)
{
    const auto number = [&] { return 2.0 * random.unit() - 1.0; };
    for (;;) {
        const glm::dvec3 normal(number(), number(), number());
        const double square = glm::dot(normal, normal);
        if (square > 1.0 || square < 0.01) continue;
        return plane_through(0.12 * glm::dvec3(number(), number(), number()), normal);
    }
}

/// What is seen of the caps of a picture.
struct SeenCaps
{
    std::set<std::array<std::uint8_t, 3>> colours;
    std::size_t pixels = 0;
    glm::dvec3 mean{0.0};  ///< sRGB, 0 to 1

    double light() const { return glm::dot(mean, glm::dvec3(0.2126, 0.7152, 0.0722)); }
    /// Degrees: 0 red, 120 green, 240 blue.
    double hue() const
    {
        const double angle = std::atan2(std::sqrt(3.0) * (mean.y - mean.z), 2.0 * mean.x - mean.y - mean.z);
        return angle * 57.29577951308232;
    }
};

class FruitLook : public GlTest
{
protected:
    struct View
    {
        Picture picture;
        std::vector<PixelFacts> facts;
    };

    View view(std::vector<StagedPiece> pieces, DrawOptions options, render::Viewpoint viewpoint)
    {
        const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
        const std::vector<DrawnObject> objects = drawn(pieces, fragments);
        options.wall = false;
        target.bind();
        renderer.draw(viewpoint, objects, options, {0, 0, kWidth, kHeight});
        target.resolve();
        return {target.read(), inspection.draw(viewpoint, objects)};
    }

    View view(std::vector<StagedPiece> pieces) { return view(std::move(pieces), {}, near_viewpoint(kWidth, kHeight)); }

    static SeenCaps caps_of(const View& seen)
    {
        SeenCaps caps;
        for (std::size_t i = 0; i < seen.facts.size(); ++i) {
            if (!seen.facts[i].is_cap()) continue;
            const std::uint8_t* p = seen.picture.rgba.data() + 4 * i;
            caps.colours.insert({p[0], p[1], p[2]});
            caps.mean += glm::dvec3(p[0], p[1], p[2]) / 255.0;
            ++caps.pixels;
        }
        caps.mean /= static_cast<double>(std::max<std::size_t>(caps.pixels, 1));
        return caps;
    }

    render::LookTable looks;
    render::FragmentStore store{looks};
    render::SceneRenderer renderer{looks};
    render::FrameTarget target{kWidth, kHeight};
    render::InspectionPass inspection{kWidth, kHeight};
};

class FruitCap : public FruitLook, public ::testing::WithParamInterface<std::string>
{
};

}  // namespace

TEST_P(FruitCap, IsNeitherClayNorBlackWhateverThePlane)
{
    core::Random random(5);
    for (const std::string& name : kFruit)
        for (int trial = 0; trial < 6; ++trial) {
            const Plane plane = any_plane(random);
            const View seen = view(opened(GetParam(), fruit(name), plane));
            std::set<std::array<std::uint8_t, 3>> colours;
            std::vector<double> light;
            std::size_t black = 0, clipped = 0;
            for (std::size_t i = 0; i < seen.facts.size(); ++i) {
                if (!seen.facts[i].is_cap()) continue;
                const std::uint8_t* p = seen.picture.rgba.data() + 4 * i;
                colours.insert({p[0], p[1], p[2]});
                light.push_back(luminance(p));
                black += light.back() < 0.05;
                clipped += std::min({p[0], p[1], p[2]}) >= 250;
            }
            SCOPED_TRACE(name + ", trial " + std::to_string(trial));
            ASSERT_GT(light.size(), 150u);
            EXPECT_GE(colours.size(), 30u);
            const auto middle = light.begin() + static_cast<std::ptrdiff_t>(light.size() / 2);
            std::nth_element(light.begin(), middle, light.end());
            EXPECT_GE(*middle, 0.15);
            EXPECT_LE(*middle, 0.9);
            EXPECT_LE(static_cast<double>(black), 0.01 * static_cast<double>(light.size()));
            EXPECT_LE(static_cast<double>(clipped), 0.01 * static_cast<double>(light.size()));
        }
}

// A cut that faces away from the light shows the light in the flesh: darker, but of the same colours.
TEST_P(FruitCap, IsFleshInTheShadeToo)
{
    const Plane plane = plane_through(glm::dvec3(0.02, 0.03, 0.02), glm::dvec3(0.1, 1.0, 0.15));
    for (const std::string& name : kFruit) {
        if (name == "bomb") continue;  // light does not get into powder
        const SeenCaps shady = caps_of(view(opened(GetParam(), fruit(name), plane, kShady)));
        const SeenCaps bright = caps_of(view(opened(GetParam(), fruit(name), plane)));
        SCOPED_TRACE(name);
        ASSERT_GT(shady.pixels, 100u);
        EXPECT_GE(shady.colours.size(), 30u);
        EXPECT_GE(shady.light(), 0.65 * bright.light());
        EXPECT_LE(shady.light(), 0.92 * bright.light()) << "it has no form";
        const double apart = std::abs(shady.hue() - bright.hue());
        EXPECT_LE(std::min(apart, 360.0 - apart), 13.0) << shady.hue() << " and " << bright.hue() << " degrees";
    }
}

// Eye, lamp and object turned alike: nothing that is seen may depend on where the object is.
TEST_P(FruitCap, IsFixedToTheFruitHoweverItTumbles)
{
    DrawOptions options;
    options.lights.sky = options.lights.ground = glm::vec3(0.0f);  // they come from above and below, not with the eye
    options.lights.shadow = 0.0f;
    const std::string& backend = GetParam();
    const Plane plane = plane_through(glm::dvec3(0.01, 0.03, 0.02), glm::dvec3(0.5, 0.7, 0.4));
    for (const std::string& name : kFruit) {
        const render::Viewpoint straight = near_viewpoint(kWidth, kHeight);
        const View still = view(opened(backend, fruit(name), plane), options, straight);
        const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), 1.9f, glm::normalize(glm::vec3(0.6f, -0.4f, 0.7f)));
        std::vector<StagedPiece> turned = opened(backend, fruit(name), plane);
        for (StagedPiece& piece : turned) piece.model = turn * piece.model;
        render::Viewpoint from_there = straight;
        from_there.eye = glm::vec3(turn * glm::vec4(straight.eye, 1.0f));
        from_there.view = straight.view * glm::inverse(turn);
        DrawOptions lit_from_there = options;
        lit_from_there.lights.to_light = glm::mat3(turn) * options.lights.to_light;
        const View tumbled = view(std::move(turned), lit_from_there, from_there);

        std::size_t seen = 0, different = 0;
        for (std::size_t i = 0; i < still.facts.size(); ++i) {
            if (still.facts[i].object == 0) continue;
            ++seen;
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most =
                    std::max(most, std::abs(int(still.picture.rgba[4 * i + c]) - int(tumbled.picture.rgba[4 * i + c])));
            different += most > 12;
        }
        EXPECT_GT(seen, 600u) << name;
        // Rounding decides about single pixels at outlines and at the edges of seeds.
        EXPECT_LT(static_cast<double>(different), 0.02 * static_cast<double>(seen)) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(BackEnds, FruitCap, ::testing::ValuesIn(back_end_of_each_kind()),
                         [](const auto& param) { return test_name_of(param.param); });

TEST_F(FruitLook, FleshIsTheSameFromBothBackEnds)
{
    const std::vector<std::string> both = back_end_of_each_kind();
    if (both.size() < 2) GTEST_SKIP() << "one back end in this build";
    const Plane plane = plane_through(glm::dvec3(0.0, 0.05, 0.02), glm::dvec3(0.3, 0.9, 0.2));
    // Convex sections: a fan covers them as a triangulation does.
    for (const char* name : {"watermelon", "orange", "lemon", "kiwi"}) {
        const View a = view(opened(both[0], fruit(name), plane));
        const View b = view(opened(both[1], fruit(name), plane));
        std::size_t caps = 0, different = 0;
        for (std::size_t i = 0; i < a.facts.size(); ++i) {
            if (!a.facts[i].is_cap() || !b.facts[i].is_cap()) continue;
            ++caps;
            for (std::size_t c = 0; c < 3; ++c)
                if (std::abs(int(a.picture.rgba[4 * i + c]) - int(b.picture.rgba[4 * i + c])) > 12) {
                    ++different;
                    break;
                }
        }
        EXPECT_GT(caps, 800u) << name;
        EXPECT_LT(static_cast<double>(different), 0.02 * static_cast<double>(caps)) << name;
    }
}

TEST_F(FruitLook, ShowsTheSkinOnlyAtTheEdgeOfACut)
{
    // The shaders repeat the outlines that the meshes have: were they different, the rind would be too wide or missing.
    const Plane across = plane_through(glm::dvec3(0.0, 0.02, 0.0), glm::dvec3(0.0, 1.0, 0.0));
    const std::string backend = back_end_of_each_kind().front();
    const View seen = view(opened(backend, fruit("watermelon"), across));
    // pattern_scale is 1 / diagonal: back to metres.
    const auto size = static_cast<float>(2.0 * sim::radius_of(fruit("watermelon").bounds()));
    std::size_t rim = 0, green_rim = 0, inner = 0, red_inner = 0;
    for (std::size_t i = 0; i < seen.facts.size(); ++i) {
        if (!seen.facts[i].is_cap()) continue;
        const std::uint8_t* p = seen.picture.rgba.data() + 4 * i;
        const glm::vec3 place = seen.facts[i].place * size;
        const float share = glm::length(glm::vec2(place.x, place.z)) / 0.80f;
        if (share > 0.92f && share < 0.96f) {
            ++rim;
            green_rim += p[1] > p[0];
        } else if (share < 0.75f) {
            ++inner;
            red_inner += p[0] > p[1];
        }
    }
    ASSERT_GT(rim, 50u);
    ASSERT_GT(inner, 400u);
    EXPECT_GT(static_cast<double>(green_rim), 0.8 * static_cast<double>(rim));
    EXPECT_GT(static_cast<double>(red_inner), 0.9 * static_cast<double>(inner));
}

TEST_F(FruitLook, HasNoDashedRimWhereACutIsSeenEdgeOn)
{
    // A pixel that a triangle covers in part takes its colour from a place beside the triangle: beyond the skin.
    DrawOptions options;
    options.lights.sky = options.lights.ground = glm::vec3(1.0f);
    options.lights.shadow = 0.0f;
    const Plane across = plane_through(glm::dvec3(0.0, 0.02, 0.0), glm::dvec3(0.0, 1.0, 0.0));
    for (const float lift : {0.06f, 0.1f, 0.14f}) {
        std::vector<StagedPiece> pieces = opened(back_end_of_each_kind().front(), fruit("lemon"), across);
        // The half stands upright, its button out of sight.
        const glm::mat4 upright = glm::rotate(glm::mat4(1.0f), lift, glm::vec3(1.0f, 0.0f, 0.0f)) *
                                  glm::mat4(glm::transpose(glm::mat3(facing(glm::vec3(across.normal())))));
        for (StagedPiece& piece : pieces) piece.model = upright * piece.model;
        const View seen = view(std::move(pieces), options, near_viewpoint(kWidth, kHeight));
        std::size_t bright = 0, brown = 0;
        for (std::size_t i = 0; i < seen.facts.size(); ++i) {
            const std::uint8_t* p = seen.picture.rgba.data() + 4 * i;
            if (p[0] < 60) continue;
            ++bright;
            brown += p[0] > 1.25 * p[1];
        }
        EXPECT_GT(bright, 1000u) << "lifted by " << lift;
        EXPECT_EQ(brown, 0u) << "lifted by " << lift << ", of " << bright;
    }
}

TEST_F(FruitLook, EveryPatternHasAProgram)
{
    for (std::size_t pattern = 0; pattern < render::kPatterns; ++pattern)
        EXPECT_NO_THROW(renderer.warm_up(static_cast<render::Pattern>(pattern)));
}

TEST_F(FruitLook, AllFruitTogetherLeaveRoomInTheTableOfLooks)
{
    const Plane across = plane_through(glm::dvec3(0.0, 0.02, 0.0), glm::dvec3(0.0, 1.0, 0.0));
    std::uint32_t most = 0;
    for (const std::string& name : kFruit) {
        const Mesh mesh = fruit(name);
        const std::vector<StagedPiece> pieces = opened(back_end_of_each_kind().front(), mesh, across);
        ASSERT_EQ(pieces.size(), 1u) << name;
        const Object& half = pieces.front().object;
        std::vector<Material> materials;
        for (std::size_t m = 0; m < half.material_count(); ++m) materials.push_back(half.material(m));
        const auto cap = static_cast<std::uint32_t>(mesh.material_count());
        ASSERT_EQ(materials.size(), cap + 1u) << "the cut adds one";
        for (std::uint32_t m = 0; m < materials.size(); ++m)
            for (const TriangleKind kind : {TriangleKind::surface, TriangleKind::cap})
                most = std::max(most, looks.index_of(materials, m, kind));
        // A cap has the look of this fruit's flesh, not the clay of unknown objects.
        const render::SurfaceLook inside = render::look_of(materials, cap, TriangleKind::cap);
        EXPECT_TRUE(std::any_of(render::fruit_flesh().begin(), render::fruit_flesh().end(), [&](const auto& flesh) {
            return flesh.first == name && flesh.second == inside;
        })) << name;
    }
    EXPECT_LT(most, render::LookTable::kMostLooks / 2);
}

}  // namespace kerf::test
