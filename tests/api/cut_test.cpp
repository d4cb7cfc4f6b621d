#include <kerf/cut.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "api/objects.h"

namespace kerf {
namespace {

class CutTest : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(All, CutTest, testing::ValuesIn(test::back_end_names()),
                         [](const auto& param) { return param.param; });

TEST_P(CutTest, GivesBothSidesAndTheirSection)
{
    Cut result = cut(test::cube(GetParam()), Plane::x(0.25).value());
    EXPECT_EQ(result.status, Status::done);
    EXPECT_TRUE(result.object.is_empty());
    EXPECT_NEAR(result.section_area, 4.0, 1e-6);
    EXPECT_FALSE(result.caps_exceed_section);
    ASSERT_EQ(result.count(Side::positive), 1u);
    ASSERT_EQ(result.count(Side::negative), 1u);
    const Object &above = *result.one(Side::positive), &below = *result.one(Side::negative);
    EXPECT_NEAR(above.mass_properties().volume, 3.0, 1e-6);
    EXPECT_NEAR(below.mass_properties().volume, 5.0, 1e-6);
    EXPECT_TRUE(above.mass_properties().is_of_solid);
    EXPECT_EQ(above.bounds().lo.x, 0.25f);
    EXPECT_EQ(result.piece(Side::positive, 1), nullptr);
    EXPECT_EQ(result.statistics().triangles, 12u);
    EXPECT_EQ(result.statistics().section_loops, 1u);
    ASSERT_EQ(above.loop_count(), 1u);
    EXPECT_TRUE(above.loop(0).is_closed);
    for (const Vec3f& p : above.loop(0).points) EXPECT_EQ(p.x, 0.25f);
}

TEST_P(CutTest, OfAMissSaysOnWhichSideTheObjectLiesAndGivesItBack)
{
    Cut missed = cut(test::cube(GetParam()), Plane::x(2.0).value());
    EXPECT_EQ(missed.status, Status::missed);
    EXPECT_EQ(missed.side_of_object, Side::negative);
    EXPECT_EQ(missed.object.triangle_count(), 12u);
    EXPECT_EQ(missed.one(Side::positive), nullptr);
    EXPECT_EQ(missed.one(Side::negative), nullptr);
    EXPECT_EQ(missed.section_area, 0.0);
    missed = cut(std::move(missed.object), Plane::x(-2.0).value());
    EXPECT_EQ(missed.status, Status::missed);
    EXPECT_EQ(missed.side_of_object, Side::positive);
    EXPECT_EQ(missed.object.triangle_count(), 12u);
}

TEST_P(CutTest, OfACopyLeavesTheObject)
{
    const Object object = test::cube(GetParam());
    const std::string before = test::bytes_of(*object.mesh());
    Cut result = cut_copy(object, Plane::z(0.0).value());
    EXPECT_EQ(result.status, Status::done);
    EXPECT_NE(result.one(Side::positive), nullptr);
    EXPECT_EQ(test::bytes_of(*object.mesh()), before);
    Cut missed = cut_copy(object, Plane::z(5.0).value());
    EXPECT_EQ(missed.status, Status::missed);
    EXPECT_TRUE(missed.object.is_empty()) << "the copy is gone, the object is where it was";
}

TEST_P(CutTest, WithoutCapsLeavesTheSectionOpen)
{
    CutOptions options;
    options.cap = false;
    Cut result = cut(test::cube(GetParam()), Plane::x(0.25).value(), options);
    EXPECT_EQ(result.status, Status::done);
    const Object& above = *result.one(Side::positive);
    EXPECT_FALSE(above.mesh()->is_closed());
    EXPECT_FALSE(above.mass_properties().is_of_solid);
    EXPECT_EQ(above.material_count(), test::cube(GetParam()).material_count()) << "there is no cap to have one";
}

TEST_P(CutTest, GivesEachConnectedPieceIfAskedTo)
{
    const Mesh mesh = test::mesh_of(test::two_cubes());
    CutOptions options;
    options.components = true;
    Cut result = cut(test::object_of(mesh, GetParam()), Plane::z(0.5).value(), options);
    EXPECT_EQ(result.count(Side::positive), 2u);
    EXPECT_EQ(result.count(Side::negative), 2u);
    double volume = 0.0;
    std::size_t pieces = 0;
    for (const Side side : {Side::negative, Side::positive})
        for (std::size_t i = 0; Object* piece = result.piece(side, i); ++i) {
            volume += piece->mass_properties().volume;
            ++pieces;
            EXPECT_TRUE(piece->mass_properties().is_of_solid);
        }
    EXPECT_EQ(pieces, 4u);
    EXPECT_NEAR(volume, 16.0, 1e-5);
    result = cut(test::object_of(mesh, GetParam()), Plane::z(0.5).value());
    EXPECT_EQ(result.count(Side::positive), 1u);
}

TEST_P(CutTest, ScalesTheUvOfCaps)
{
    const auto largest_uv = [&](double scale) {
        CutOptions options;
        options.cap_uv_scale = scale;
        Cut result = cut(test::cube(GetParam()), Plane::x(0.25).value(), options);
        const Mesh mesh = *result.one(Side::positive)->mesh();
        const MeshArrays arrays = mesh.arrays();
        float largest = 0.0f;
        for (std::size_t t = 0; t < arrays.kinds.size(); ++t)
            if (arrays.kinds[t] == TriangleKind::cap)
                for (std::size_t i = 0; i < 3; ++i)
                    largest = std::max(largest, std::abs(arrays.uvs[arrays.indices[3 * t + i]].x));
        return largest;
    };
    EXPECT_FLOAT_EQ(largest_uv(1.0), 1.0f);
    EXPECT_FLOAT_EQ(largest_uv(8.0), 8.0f);
}

TEST_P(CutTest, WithAGapTakesTheBladeAway)
{
    CutOptions options;
    options.gap = 0.5;
    Cut result = cut(test::cube(GetParam()), Plane::x(0.25).value(), options);
    ASSERT_EQ(result.status, Status::done);
    ASSERT_EQ(result.count(Side::positive), 1u);
    ASSERT_EQ(result.count(Side::negative), 1u);
    EXPECT_EQ(result.one(Side::positive)->bounds().lo.x, 0.5f);
    EXPECT_EQ(result.one(Side::negative)->bounds().hi.x, 0.0f);
    EXPECT_TRUE(result.one(Side::negative)->mesh()->is_closed());
    EXPECT_EQ(result.statistics().section_loops, 2u);
}

TEST_P(CutTest, WithAGapMissesWhatTheBladeDoesNotTouch)
{
    CutOptions options;
    options.gap = 0.5;
    Cut result = cut(test::cube(GetParam()), Plane::x(1.5).value(), options);
    EXPECT_EQ(result.status, Status::missed);
    EXPECT_EQ(result.side_of_object, Side::negative);
    EXPECT_EQ(result.object.triangle_count(), 12u);
    result = cut(std::move(result.object), Plane::x(-1.5).value(), options);
    EXPECT_EQ(result.status, Status::missed);
    EXPECT_EQ(result.side_of_object, Side::positive);
    // The blade takes a corner off and leaves one side only.
    result = cut(std::move(result.object), Plane::x(1.0).value(), options);
    EXPECT_EQ(result.status, Status::done);
    EXPECT_EQ(result.count(Side::positive), 0u);
    EXPECT_EQ(result.one(Side::negative)->bounds().hi.x, 0.75f);
    EXPECT_NEAR(result.section_area, 4.0, 1e-6);
    // A blade as thick as the object leaves nothing.
    options.gap = 10.0;
    result = cut(std::move(*result.one(Side::negative)), Plane::x(0.0).value(), options);
    EXPECT_EQ(result.status, Status::done);
    EXPECT_TRUE(result.object.is_empty());
    EXPECT_EQ(result.count(Side::positive) + result.count(Side::negative), 0u);
}

TEST_P(CutTest, OfOnePlaceAloneLeavesTheRest)
{
    CutOptions options;
    options.only = OnlyNear{{0.1, -0.5, 0.0}};
    options.gap = 0.1;
    Cut result = cut(test::cube(GetParam()), Plane::x(0.0).value(), options);
    EXPECT_EQ(result.status, Status::invalid_argument);
    EXPECT_STREQ(result.reason(), "a cut at one place has no gap: set `only` or `gap`");
    options.gap = 0.0;
    result = cut(std::move(result.object), Plane::x(0.0).value(), options);
    EXPECT_EQ(result.status, Status::done);
    options.only->point.y = std::numeric_limits<double>::infinity();
    result = cut(std::move(*result.one(Side::positive)), Plane::x(0.5).value(), options);
    EXPECT_EQ(result.status, Status::invalid_argument);
    EXPECT_FALSE(result.object.is_empty());

    const Mesh ring = test::shape("torus", 600);
    options.only->point = {0.0, 1.0, 0.0};
    const std::uint64_t triangles = ring.triangle_count();
    result = cut(test::object_of(ring, GetParam()), test::plane_at(0.01, 0.01, 0.01, 1.0, 0.02, 0.01), options);
    // If it lies in that plane, its section is one region with a hole.
    if (result.status == Status::done)
        result = cut(test::object_of(ring, GetParam()), test::plane_at(0.01, 0.01, 0.01, 0.02, 0.01, 1.0), options);
    EXPECT_EQ(result.status, Status::not_separated);
    EXPECT_EQ(result.object.triangle_count(), triangles);
    EXPECT_STREQ(result.reason(),
                 "a cut there alone would not part the object: what lies on both sides of it is connected elsewhere");
    EXPECT_STREQ(text(result.status), "not separated");
    EXPECT_STREQ(outcome_name(result.status), "not_separated");
}

TEST(CutWithAGap, IsTheTwoCutsThatItStandsFor)
{
    rc::check([](std::uint64_t seed, bool components) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> number(-0.5, 0.5);
        const Plane plane = test::plane_at(number(random), number(random), number(random), number(random) + 1.0,
                                           number(random), number(random));
        CutOptions options, without_gap;
        options.gap = 0.5 + number(random);
        options.components = without_gap.components = components;
        for (const std::string& name : test::back_end_names()) {
            const Object object = test::object_of(test::shape("torus", 400), name);
            Cut both = cut_copy(object, plane, options);
            Cut upper = cut_copy(object, *plane.moved(0.5 * options.gap), without_gap);
            Cut lower = cut_copy(object, *plane.moved(-0.5 * options.gap), without_gap);
            const auto volume = [](Cut& result, Side side) {
                double sum = 0.0;
                for (std::size_t i = 0; Object* piece = result.piece(side, i); ++i)
                    sum += piece->mass_properties().volume;
                return sum;
            };
            if (!ok(upper.status) || !ok(lower.status)) return;
            RC_ASSERT(std::abs(volume(both, Side::positive) - volume(upper, Side::positive)) < 1e-5);
            RC_ASSERT(std::abs(volume(both, Side::negative) - volume(lower, Side::negative)) < 1e-5);
            RC_ASSERT(both.count(Side::positive) == upper.count(Side::positive));
            RC_ASSERT(both.count(Side::negative) == lower.count(Side::negative));
        }
    });
}

TEST_P(CutTest, OfNumbersThatMeanNothingIsRefusedAndGivesTheObjectBack)
{
    Object object = test::cube(GetParam());
    for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        for (const int which : {0, 1}) {
            CutOptions options;
            (which == 0 ? options.gap : options.cap_uv_scale) = bad;
            Cut refused = cut(std::move(object), Plane::x(0.0).value(), options);
            EXPECT_EQ(refused.status, Status::invalid_argument);
            EXPECT_STREQ(refused.reason(), which == 0 ? "the gap must be a finite width, 0 or more"
                                                      : "the uv scale of caps must be finite");
            object = std::move(refused.object);
            EXPECT_EQ(object.triangle_count(), 12u);
        }
    CutOptions options;
    options.cap_quality = static_cast<CapQuality>(9);
    Cut of_no_quality = cut(std::move(object), Plane::x(0.0).value(), options);
    EXPECT_EQ(of_no_quality.status, Status::invalid_argument);
    EXPECT_STRNE(of_no_quality.reason(), "");
    object = std::move(of_no_quality.object);
    options = {};
    options.gap = -1.0;
    Cut refused = cut(std::move(object), Plane::x(0.0).value(), options);
    EXPECT_EQ(refused.status, Status::invalid_argument);
    EXPECT_STREQ(refused.reason(), "the gap must be a finite width, 0 or more");
    EXPECT_STREQ(cut_copy(refused.object, Plane::x(0.0).value(), options).reason(), refused.reason());
    const Cut moved = std::move(refused);
    EXPECT_STREQ(moved.reason(), "the gap must be a finite width, 0 or more");
    // What was cut, or missed, needs no reason.
    EXPECT_STREQ(cut(test::cube(GetParam()), Plane::x(0.0).value()).reason(), "");
    EXPECT_STREQ(cut(test::cube(GetParam()), Plane::x(9.0).value()).reason(), "");
}

TEST_P(CutTest, ClosesByDelaunayWhereTheProgramCan)
{
    EXPECT_TRUE(has_cap_quality(CapQuality::fast));
    const Mesh torus = test::shape("torus");
    CutOptions options;
    options.cap_quality = CapQuality::delaunay;
    Cut result = cut(test::object_of(torus, GetParam()), Plane::z(0.01).value(), options);
    if (!has_cap_quality(CapQuality::delaunay)) {
        EXPECT_EQ(result.status, Status::invalid_argument);
        EXPECT_STREQ(result.reason(),
                     "this program has no Delaunay triangulation: link Kerf's component caps_cgal, or "
                     "ask for fast caps");
        EXPECT_EQ(result.object.triangle_count(), torus.triangle_count());
        return;
    }
    ASSERT_EQ(result.status, Status::done);
    Cut fast = cut(test::object_of(torus, GetParam()), Plane::z(0.01).value());
    const Object &fine = *result.one(Side::positive), &quick = *fast.one(Side::positive);
    EXPECT_TRUE(fine.mesh()->is_closed());
    EXPECT_EQ(fine.triangle_count(), quick.triangle_count());
    EXPECT_NE(test::bytes_of(*fine.mesh()), test::bytes_of(*quick.mesh()));
    EXPECT_NEAR(fine.mass_properties().volume, quick.mass_properties().volume, 1e-6);
}

TEST(Cut, IsTheSameByEveryBackEndOnItsSurface)
{
    const auto surface_of = [](const Object& object) {
        const Mesh mesh = *object.mesh();
        const MeshArrays arrays = mesh.arrays();
        std::vector<std::array<float, 9>> triangles;
        for (std::size_t t = 0; t < arrays.kinds.size(); ++t) {
            if (arrays.kinds[t] == TriangleKind::cap) continue;
            std::array<std::array<float, 3>, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3f& p = arrays.positions[arrays.indices[3 * t + i]];
                corners[i] = {p.x, p.y, p.z};
            }
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            std::array<float, 9> flat;
            for (std::size_t i = 0; i < 9; ++i) flat[i] = corners[i / 3][i % 3];
            triangles.push_back(flat);
        }
        std::sort(triangles.begin(), triangles.end());
        return triangles;
    };
    for (const char* name : {"torus", "comb", "menger_sponge"}) {
        const Mesh mesh = test::shape(name);
        std::vector<std::vector<std::array<float, 9>>> found;
        for (const std::string& back_end : test::back_end_names()) {
            Cut result = cut(test::object_of(mesh, back_end), test::plane_at(0.01, 0.02, 0.03, 0.3, 0.5, 0.8));
            ASSERT_EQ(result.status, Status::done);
            found.push_back(surface_of(*result.one(Side::positive)));
        }
        for (const auto& surface : found) EXPECT_EQ(surface, found.front());
    }
}

}  // namespace
}  // namespace kerf
