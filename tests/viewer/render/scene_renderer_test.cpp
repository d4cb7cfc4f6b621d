#include "viewer/render/scene_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <limits>
#include <utility>

#include "common/mesh/plane_frame.h"
#include "common/support/median.h"
#include "support/brief.h"
#include "viewer/render/frame_target.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/inspection_pass.h"
#include "viewer/render/pieces_on_stage.h"
#include "viewer/support/stages.h"

namespace kerf::test {

namespace {

using render::DrawnFragment;
using render::DrawnObject;
using render::DrawOptions;
using render::FrameTarget;
using render::InspectionPass;
using render::Lighting;
using render::Picture;
using render::PixelFacts;

class SceneRendererTest : public GlTest, public ::testing::WithParamInterface<std::string>
{
protected:
    Picture picture_of(const std::vector<DrawnObject>& objects, const DrawOptions& options)
    {
        target.bind();
        renderer.draw(near_viewpoint(kWidth, kHeight), objects, options, {0, 0, kWidth, kHeight});
        target.resolve();
        return target.read();
    }

    render::LookTable looks;
    render::FragmentStore store{looks};
    render::SceneRenderer renderer{looks};
    FrameTarget target{kWidth, kHeight};
};

/// What a ray through the middle of a pixel meets first, found on the processor: 0 nothing, 1 surface, 2 cap.
class RayReferee
{
public:
    explicit RayReferee(const std::vector<StagedPiece>& pieces)
    {
        for (const StagedPiece& piece : pieces) {
            const Mesh mesh = value_of(piece.object.mesh());
            const MeshArrays arrays = mesh.arrays();
            for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
                std::array<glm::dvec3, 3> corners;
                for (std::size_t c = 0; c < 3; ++c) {
                    const glm::vec3 position(arrays.positions[arrays.indices[3 * t + c]]);
                    corners[c] = glm::dvec3(piece.model * glm::vec4(position, 1.0f));
                }
                triangles_.push_back({corners, arrays.kinds[t] == TriangleKind::cap ? 2 : 1});
            }
        }
    }

    int first_hit(const glm::dvec3& eye, const glm::dvec3& direction) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        int kind = 0;
        for (const auto& [corners, its_kind] : triangles_) {
            // eye + s * direction = a + u * (b - a) + v * (c - a), by Cramer's rule
            const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0], ae = eye - corners[0];
            const double det = glm::determinant(glm::dmat3(-direction, ab, ac));
            if (det == 0.0) continue;
            const double s = glm::determinant(glm::dmat3(ae, ab, ac)) / det;
            const double u = glm::determinant(glm::dmat3(-direction, ae, ac)) / det;
            const double v = glm::determinant(glm::dmat3(-direction, ab, ae)) / det;
            if (s <= 0.0 || u < 0.0 || v < 0.0 || u + v > 1.0 || s >= nearest) continue;
            nearest = s;
            kind = its_kind;
        }
        return kind;
    }

private:
    std::vector<std::pair<std::array<glm::dvec3, 3>, int>> triangles_;
};

std::vector<int> kinds_by_rays(const std::vector<StagedPiece>& pieces)
{
    const RayReferee referee(pieces);
    const render::Viewpoint viewpoint = near_viewpoint(kWidth, kHeight);
    const glm::dmat4 to_world = glm::inverse(glm::dmat4(viewpoint.projection) * glm::dmat4(viewpoint.view));
    std::vector<int> kinds;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const glm::dvec4 far =
                to_world * glm::dvec4(2.0 * (x + 0.5) / kWidth - 1.0, 1.0 - 2.0 * (y + 0.5) / kHeight, 1.0, 1.0);
            const glm::dvec3 eye(viewpoint.eye);
            kinds.push_back(referee.first_hit(eye, glm::dvec3(far) / far.w - eye));
        }
    return kinds;
}

/// In a list of all pixels.
std::size_t place_of(int x, int y)
{
    return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
}

/// A pixel whose neighbours see the same: rounding at an outline decides nothing there.
bool is_inner(const std::vector<int>& kinds, int x, int y)
{
    if (x < 1 || y < 1 || x >= kWidth - 1 || y >= kHeight - 1) return false;
    const auto at = [&](int px, int py) { return kinds[place_of(px, py)]; };
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (at(x + dx, y + dy) != at(x, y)) return false;
    return true;
}

}  // namespace

TEST_P(SceneRendererTest, RangesOfSharedBuffersLookLikeCopiesPixelForPixel)
{
    for (const char* model : {"monkey", "car"}) {
        std::vector<StagedPiece> pieces = pieces_of(model, GetParam(), 3, 0.7f);
        const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
        std::vector<StagedPiece> copies;
        for (const StagedPiece& piece : pieces)
            copies.push_back({object_of(value_of(piece.object.mesh()), "baseline/hash"), piece.model,
                              piece.pattern_scale, piece.plane, piece.is_closed, piece.images});
        const std::vector<DrawnFragment> fragments_of_copies = uploaded(store, copies);
        for (const Lighting lighting : {Lighting::lambert, Lighting::textured}) {
            DrawOptions options;
            options.lighting = lighting;
            const Picture by_ranges = picture_of(drawn(pieces, fragments), options);
            const Picture by_copies = picture_of(drawn(copies, fragments_of_copies), options);
            EXPECT_TRUE(by_ranges == by_copies) << model;
            EXPECT_GT(std::count_if(by_ranges.rgba.begin(), by_ranges.rgba.end(), [](int b) { return b > 40; }), 1000);
        }
    }
}

TEST_P(SceneRendererTest, ShowsSurfacesAndCapsWhereRaysMeetThem)
{
    InspectionPass inspection(kWidth, kHeight);
    for (const char* model : {"rook", "sphere"}) {
        std::vector<StagedPiece> pieces = pieces_of(model, GetParam(), 2, 0.4f);
        const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
        const auto seen = inspection.draw(near_viewpoint(kWidth, kHeight), drawn(pieces, fragments));
        const std::vector<int> expected = kinds_by_rays(pieces);
        std::array<int, 3> compared{};
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                if (!is_inner(expected, x, y)) continue;
                const auto pixel = place_of(x, y);
                ++compared[static_cast<std::size_t>(expected[pixel])];
                ASSERT_EQ(seen[pixel].kind, static_cast<std::uint32_t>(expected[pixel]))
                    << model << " at " << x << ", " << y;
            }
        for (const int count : compared) EXPECT_GT(count, 100) << model;
        if (kBrief) return;  // the rays take half a minute where tests are not optimised
    }
}

TEST_P(SceneRendererTest, LightsCapsInEveryPose)
{
    InspectionPass inspection(kWidth, kHeight);
    for (const Lighting lighting : {Lighting::lambert, Lighting::textured})
        for (const float turn : {0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f}) {
            std::vector<StagedPiece> pieces = pieces_of("rook", GetParam(), 1, turn);
            const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
            const auto objects = drawn(pieces, fragments);
            const auto seen = inspection.draw(near_viewpoint(kWidth, kHeight), objects);
            DrawOptions options;
            options.lighting = lighting;
            const Picture picture = picture_of(objects, options);
            std::vector<double> lit;
            for (std::size_t i = 0; i < seen.size(); ++i)
                if (seen[i].is_cap()) lit.push_back(luminance(picture.rgba.data() + 4 * i));
            ASSERT_GT(lit.size(), 50u) << "turn " << turn;
            const double middle = core::median(std::move(lit));
            EXPECT_GE(middle, 0.15) << "turn " << turn;
            EXPECT_LE(middle, 0.9) << "turn " << turn;
        }
}

TEST_P(SceneRendererTest, CapUvStayWhereTheyAreOnATumblingObject)
{
    InspectionPass inspection(kWidth, kHeight);
    std::size_t compared = 0;
    for (const float turn : {0.0f, 0.9f, 2.1f, 4.0f}) {
        std::vector<StagedPiece> pieces = pieces_of("rook", GetParam(), 1, turn);
        const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
        const auto seen = inspection.draw(near_viewpoint(kWidth, kHeight), drawn(pieces, fragments));
        for (const PixelFacts& pixel : seen) {
            if (!pixel.is_cap()) continue;
            const StagedPiece& piece = pieces[pixel.object - 1];
            const core::PlaneFrame frame = core::PlaneFrame::of(glm::dvec3(piece.plane->normal()));
            const glm::dvec3 place = glm::dvec3(pixel.place) / double(piece.pattern_scale);
            const glm::dvec2 expected(glm::dot(frame.u, place), glm::dot(frame.v, place));
            // A hundredth of a pixel's size on the object.
            const double tolerance = 1e-4 / double(piece.pattern_scale);
            ASSERT_NEAR(double(pixel.uv.x), expected.x, tolerance);
            ASSERT_NEAR(double(pixel.uv.y), expected.y, tolerance);
            ++compared;
        }
    }
    EXPECT_GT(compared, 500u);
}

TEST_P(SceneRendererTest, LightingsAndEdgesDiffer)
{
    std::vector<StagedPiece> pieces = pieces_of("barrel", GetParam(), 1, 0.5f);
    const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
    DrawOptions lambert, textured, wired;
    lambert.lighting = Lighting::lambert;
    wired.wireframe = true;
    const auto objects = drawn(pieces, fragments);
    const Picture a = picture_of(objects, lambert), b = picture_of(objects, textured), c = picture_of(objects, wired);
    EXPECT_FALSE(a == b);
    EXPECT_FALSE(b == c);
    EXPECT_TRUE(b == picture_of(objects, textured));
}

TEST_P(SceneRendererTest, DrawsOnlyIntoItsArea)
{
    std::vector<StagedPiece> pieces = pieces_of("cube", GetParam(), 1, 0.5f);
    const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
    const auto objects = drawn(pieces, fragments);
    const render::Viewpoint viewpoint = near_viewpoint(kWidth / 2, kHeight);
    target.bind();
    glClearColor(1.0f, 0.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    renderer.draw(viewpoint, objects, {}, {kWidth / 2, 0, kWidth / 2, kHeight});
    target.resolve();
    const Picture picture = target.read();
    const auto is_magenta = [&](int x, int y) {
        const std::uint8_t* p = picture.pixel(x, y);
        return p[0] == 255 && p[1] == 0 && p[2] == 255;
    };
    for (int y = 0; y < kHeight; ++y) {
        EXPECT_TRUE(is_magenta(kWidth / 2 - 1, y));
        EXPECT_FALSE(is_magenta(kWidth / 2, y));
    }
}

INSTANTIATE_TEST_SUITE_P(BackEnds, SceneRendererTest, ::testing::ValuesIn(back_end_of_each_kind()),
                         [](const auto& param) { return test_name_of(param.param); });

}  // namespace kerf::test
