// Sections of surfaces that run through themselves: caps are closed and cover what loops wind around, as often as they
// do; where that is more than the section's area, because loops wind backwards, the result says so. For every back end.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "common/cutting/cut.h"
#include "common/mesh/plane_noise.h"
#include "common/mesh/tolerances.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/prisms.h"
#include "support/referee.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

using test::Random;

using test::Polygon;
using test::prism_over;
using test::star;

Polygon scribble(Random& random)
{
    Polygon polygon;
    const std::uint32_t points = 4 + random.below(12);
    for (std::uint32_t i = 0; i < points; ++i) polygon.emplace_back(random.uniform(), random.uniform());
    return polygon;
}

Plane some_plane(Random& random)
{
    const glm::dvec3 tilt = random.direction();
    return *Plane::through({0, 0.4 * random.uniform() - 0.2, 0}, glm::dvec3(0.1 * tilt.x, 1, 0.1 * tilt.z));
}

struct Areas
{
    double cap = 0, wound = 0;
    double rounding = 0;  ///< what a unit in the last place along the outline does, and the sum over it
};

/// Of one side: the other one's are the same.
Areas areas_of(const CutResult& result, const Plane& plane)
{
    const Cuttable& fragment = *result.negative.front();
    Areas areas;
    areas.cap = referee::cap_area_in_plane(fragment.to_indexed_mesh(), plane.normal);
    areas.wound = referee::wound_area(fragment.section_loops(), plane.normal);
    double length = 0;
    for (const SectionLoop& loop : fragment.section_loops())
        for (std::size_t i = 0; i < loop.points.size(); ++i)
            length += glm::distance(loop.points[i], loop.points[(i + 1) % loop.points.size()]);
    areas.rounding = plane_noise(fragment.bounds().largest_coordinate()) / kNoiseInUnits * length;
    return areas;
}

class CrossingSections : public testing::TestWithParam<test::NamedBackend>
{
protected:
    CutResult cut_of(const IndexedMesh& mesh, const Plane& plane, const CutOptions& options = {}) const
    {
        return cut(std::move(backend_->prepare(mesh).object), plane, options);
    }
    bool has_fan() const { return GetParam().name.starts_with("baseline"); }
    /// Whether caps cover what the section winds around. Without CGAL they cover more, and the result says so.
    bool triangulates() const
    {
#ifdef KERF_HAS_CGAL
        return !has_fan();
#else
        return false;
#endif
    }
    /// A fan does, too.
    bool covers_stars() const
    {
        return triangulates() || has_fan();
    }

    std::unique_ptr<Backend> backend_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, CrossingSections, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

void expect_closed(const std::vector<std::unique_ptr<Cuttable>>& side)
{
    for (const auto& fragment : side) {
        const IndexedMesh mesh = fragment->to_indexed_mesh();
        EXPECT_EQ(check(mesh), "");
        EXPECT_EQ(referee::open_edges(mesh), 0u);
        EXPECT_EQ(referee::open_edges_by_position(mesh), 0u);
        EXPECT_EQ(referee::triangles_with_equal_corners(mesh), 0u);
    }
}

TEST_P(CrossingSections, StarsAreCoveredAsOftenAsTheyWind)
{
    for (const std::uint32_t points : {5u, 7u, 9u, 13u, 31u}) {
        const IndexedMesh mesh = prism_over(star(points, points / 2));
        const Plane plane = *Plane::through({0, 0.01, 0}, {0.01, 1, 0.013});
        const CutResult result = cut_of(mesh, plane);
        ASSERT_EQ(result.status, Status::done);
        expect_closed(result.positive);
        expect_closed(result.negative);
        const Areas areas = areas_of(result, plane);
        EXPECT_NEAR(areas.wound, result.section_area, 1e-6 * result.section_area);
        EXPECT_EQ(result.caps_exceed_section, areas.cap > 1.01 * result.section_area) << points;
        if (covers_stars()) {
            EXPECT_FALSE(result.caps_exceed_section) << points;
            EXPECT_NEAR(areas.cap, result.section_area, 1e-6 * result.section_area) << points;
        }
        for (const auto* side : {&result.positive, &result.negative})
            EXPECT_EQ(cut(side->front()->clone(), plane).status, Status::missed);
    }
}

TEST_P(CrossingSections, BackwardLobesAreSaid)
{
    // A bow tie of nearly equal lobes: the section's area is their difference, and both are covered.
    const Plane plane = *Plane::through({0, 0.01, 0}, {0.01, 1, 0.013});
    const CutResult result = cut_of(prism_over({{0, 0}, {2, 2.1}, {2, 0}, {0, 2}}), plane);
    ASSERT_EQ(result.status, Status::done);
    const Areas areas = areas_of(result, plane);
    EXPECT_GT(areas.wound, 10 * result.section_area);
    EXPECT_TRUE(result.caps_exceed_section);
    if (triangulates()) {
        EXPECT_NEAR(areas.cap, areas.wound, 1e-6 * areas.wound);
    }
}

/// A section of a scanned man had this corner, folded over by 1.6e-20.
const Polygon kFoldedCorner{{0.125, 0},       {0.134858117, 1.62488128e-20},
                            {0.134858117, 0}, {0.133078814, 0.00131935824},
                            {0.1, 0.1},       {0.02, 0.1},
                            {0.05, 0.05},     {0, 0}};

TEST_P(CrossingSections, ATouchTooSmallForADifferenceIsSeen)
{
    const Plane plane = *Plane::through({0, 0, 0}, {0, 1, 0});
    for (const double fold : {0.0, 1e-45, 1e-39, 1e-30, 1.62488128e-20, 1e-18, 1e-12})
        for (int turned = 0; turned < 4; ++turned) {
            SCOPED_TRACE("fold " + std::to_string(std::log10(fold)) + ", turned " + std::to_string(turned));
            Polygon polygon = kFoldedCorner;
            polygon[1].y = fold;
            for (glm::dvec2& p : polygon) {
                if ((turned & 1) != 0) p.y = -p.y;
                if ((turned & 2) != 0) std::swap(p.x, p.y);
            }
            const CutResult result = cut_of(prism_over(polygon), plane);
            ASSERT_EQ(result.status, Status::done);
            expect_closed(result.positive);
            expect_closed(result.negative);
            if (!triangulates()) continue;
            EXPECT_NEAR(areas_of(result, plane).cap, result.section_area, 1e-6 * result.section_area);
            EXPECT_FALSE(result.caps_exceed_section);
        }
}

/// A rough star with many coordinates of other sizes: of zero and around it.
Polygon of_far_exponents(Random& random)
{
    Polygon polygon;
    const std::uint32_t points = 5 + random.below(12);
    const auto tiny = [&] {
        return random.below(4) == 0 ? 0.0 : (random.uniform() - 0.5) * std::ldexp(1.0, -int(random.below(140)));
    };
    for (std::uint32_t i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points, r = 0.2 + random.uniform();
        glm::dvec2 p(r * std::cos(angle), r * std::sin(angle));
        for (int axis = 0; axis < 2; ++axis) {
            if (random.below(3) == 0) p[axis] = tiny();
            // Beside a point that is there.
            if (i > 0 && random.below(4) == 0) p[axis] = polygon[random.below(i)][axis] + tiny();
        }
        polygon.push_back(p);
    }
    return polygon;
}

TEST_P(CrossingSections, OfFarExponentsAreCoveredAsOftenAsTheyWindFourCutsInARow)
{
    Random random(11);
    std::size_t cuts = 0;
    for (int run = 0; run < 300; ++run) {
        SCOPED_TRACE(run);
        const IndexedMesh prism = prism_over(of_far_exponents(random));
        if (referee::open_edges(prism) > 0) continue;  // triangles that fall together
        std::unique_ptr<Cuttable> object = backend_->prepare(prism).object;
        for (int depth = 0; depth < 4; ++depth) {
            // Axis planes through coordinates that are there keep those of the other axes as they are.
            const IndexedMesh mesh = object->to_indexed_mesh();
            const glm::vec3 through =
                mesh.vertices[random.below(static_cast<std::uint32_t>(mesh.vertices.size()))].position;
            glm::dvec3 normal(0.0);
            normal[depth == 0 ? 1 : static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0 : -1.0;
            const Plane plane = *Plane::through(depth == 0 ? glm::vec3(0.0f) : through, normal);
            CutResult result = cut(std::move(object), plane);
            if (result.status == Status::missed) {
                object = std::move(result.object);
                continue;
            }
            ASSERT_EQ(result.status, Status::done);
            ++cuts;
            expect_closed(result.positive);
            expect_closed(result.negative);
            if (triangulates() && depth == 0) {
                const Areas areas = areas_of(result, plane);
                EXPECT_NEAR(areas.cap, areas.wound, 1e-6 * areas.wound + areas.rounding);
            }
            object = std::move(result.negative.front());
        }
    }
    EXPECT_GT(cuts, 600u);
}

TEST_P(CrossingSections, WithoutCapsNothingIsSaidOfThem)
{
    CutOptions options;
    options.build_caps = false;
    const Plane plane = *Plane::through({0, 0.01, 0}, {0.01, 1, 0.013});
    EXPECT_FALSE(cut_of(prism_over({{0, 0}, {2, 2.1}, {2, 0}, {0, 2}}), plane, options).caps_exceed_section);
}

TEST_P(CrossingSections, CapsExceedTheSectionExactlyWhereTheResultSaysSo)
{
    Random random(11);
    std::size_t said = 0, unsaid = 0;
    for (int run = 0; run < 150; ++run) {
        const IndexedMesh mesh = prism_over(run % 3 == 0 ? star(5 + 2 * random.below(6), 2) : scribble(random));
        const Plane plane = some_plane(random);
        const CutResult result = cut_of(mesh, plane);
        if (result.status != Status::done) continue;
        const Areas areas = areas_of(result, plane);
        const double excess = areas.cap - result.section_area;
        const double tolerance = std::max(kCapAgreement * std::abs(result.section_area), areas.rounding);
        if (excess > 2 * tolerance) {
            EXPECT_TRUE(result.caps_exceed_section) << run;
        } else if (excess < tolerance / 2) {
            EXPECT_FALSE(result.caps_exceed_section) << run;
        }
        ++(result.caps_exceed_section ? said : unsaid);
        if (triangulates()) {
            EXPECT_NEAR(areas.cap, areas.wound, 1e-6 * areas.wound + 4 * areas.rounding) << run;
        }
    }
    EXPECT_GT(said, 20u);
    EXPECT_GT(unsaid, 20u);
}

TEST_P(CrossingSections, PiecesAndFurtherCutsAreClosed)
{
    Random random(3);
    CutOptions options;
    for (int run = 0; run < 40; ++run) {
        options.split_components = run % 2 == 1;
        const IndexedMesh mesh = prism_over(run % 4 < 2 ? star(5 + 2 * random.below(8), 2) : scribble(random));
        std::vector<std::unique_ptr<Cuttable>> objects;
        objects.push_back(std::move(backend_->prepare(mesh).object));
        for (int generation = 0; generation < 3; ++generation) {
            const Plane plane = *Plane::through({0.5, 0, 0.5}, random.direction());
            std::vector<std::unique_ptr<Cuttable>> next;
            for (auto& object : objects) {
                CutResult result = cut(std::move(object), plane, options);
                ASSERT_TRUE(result.status == Status::done || result.status == Status::missed);
                expect_closed(result.positive);
                expect_closed(result.negative);
                if (result.object) next.push_back(std::move(result.object));
                for (auto* side : {&result.positive, &result.negative})
                    std::move(side->begin(), side->end(), std::back_inserter(next));
            }
            objects = std::move(next);
            double volume = 0;
            for (const auto& object : objects) volume += referee::volume(object->to_indexed_mesh());
            EXPECT_NEAR(volume, referee::volume(mesh), 1e-5);
        }
    }
}

TEST_P(CrossingSections, ManyMoreCrossingsThanPointsAreSaidOrCovered)
{
    // 11 000 crossings of 151 edges are untangled; a quarter of a million of 701 are not.
    for (const std::uint32_t points : {151u, 701u}) {
        const Plane plane = *Plane::through({0, 0.01, 0}, {0.01, 1, 0.013});
        const CutResult result = cut_of(prism_over(star(points, points / 2)), plane);
        ASSERT_EQ(result.status, Status::done);
        expect_closed(result.negative);
        const double cap = referee::cap_area_in_plane(result.negative.front()->to_indexed_mesh(), plane.normal);
        EXPECT_EQ(result.caps_exceed_section, cap > 1.01 * result.section_area) << points << " " << cap;
        if (covers_stars()) {
            EXPECT_EQ(result.caps_exceed_section, triangulates() && points == 701u)
                << cap << " " << result.section_area;
        }
    }
}

TEST_P(CrossingSections, StarsAreCoveredThoughClippingRefusesAPartOfThem)
{
    // One of the 75 parts has few ears at a time. Layers of triangles over the whole were 872 000.
    const Plane plane = *Plane::through({0.857226849, -1, -0.51493901}, {-0.276798519, -0.75957086, 1});
    const CutResult result = cut_of(prism_over(star(151, 75)), plane);
    ASSERT_EQ(result.status, Status::done);
    expect_closed(result.positive);
    expect_closed(result.negative);
    EXPECT_LT(result.positive.front()->triangle_count(), 65'536u);
    if (triangulates()) {
        const Areas areas = areas_of(result, plane);
        EXPECT_NEAR(areas.cap, result.section_area, 1e-6 * result.section_area + areas.rounding);
        EXPECT_FALSE(result.caps_exceed_section);
    }
}

TEST_P(CrossingSections, CoilsAreCoveredByTrianglesInProportionToTheirPoints)
{
    // Twenty points a turn, and one lobe that runs backwards: a place within a hundred turns is wound around a hundred
    // times. Triangles upon triangles were 418 000 a side.
    for (const std::uint32_t turns : {25u, 50u, 100u}) {
        Polygon coil;
        const std::uint32_t points = 20 * turns;
        for (std::uint32_t i = 0; i < points; ++i) {
            const double angle = 2 * std::numbers::pi * i / 20 + 0.1, radius = 1 - 0.5 * i / points;
            coil.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
        for (const glm::dvec2& p : {glm::dvec2(1.5, -0.1), {2, 0.3}, {2, -0.3}, {1.5, 0.1}}) coil.push_back(p);
        const CutResult result = cut_of(prism_over(coil), *Plane::through({0, 0.01, 0}, {0.01, 1, 0.013}));
        ASSERT_EQ(result.status, Status::done);
        expect_closed(result.positive);
        EXPECT_TRUE(result.caps_exceed_section);
        EXPECT_LT(result.positive.front()->triangle_count(), 12 * coil.size() + 32'768);
    }
}

TEST_P(CrossingSections, OfPointsAtEveryScaleAreCoveredByTrianglesInProportionToTheirPoints)
{
    // Hundreds of points lie along either axis, at 1 as well as at 2^-130, and each edge along it may be led over all
    // of them. Triangles were 110 000 a side for 2500 points, 399 000 for 5000.
    for (const std::uint32_t points : {2500u, 5000u}) {
        Polygon polygon;
        for (std::uint32_t i = 0; i < points; ++i) {
            const double share = double(i) / points;
            polygon.emplace_back(std::ldexp(1 + share, -int(i % 140)), std::ldexp(share, -int(7 * i % 130)));
        }
        const CutResult result = cut_of(prism_over(polygon), *Plane::through({0, 0, 0}, {0, 1, 0}));
        ASSERT_EQ(result.status, Status::done);
        expect_closed(result.positive);
        expect_closed(result.negative);
        EXPECT_LT(result.positive.front()->triangle_count(), 12 * polygon.size() + 32'768);
    }
}

// A triangle and its back in the plane: the plane takes them apart. As a solid of their own they got a cap each, which
// lay on the cap around them: coarse grids make thousands of such pairs.
TEST_P(CrossingSections, FlatShellsInThePlaneFillAHoleOfTheCap)
{
    TriangleSoup soup = small_meshes::cube();
    const std::uint32_t first = 8;
    for (const glm::vec3& p : {glm::vec3(0.25f, 0.5f, 0.25f), {0.75f, 0.5f, 0.25f}, {0.25f, 0.5f, 0.75f}})
        soup.vertices.push_back({p, glm::vec3(0.0f), glm::vec2(0.0f)});
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.triangles.push_back({first, first + 2, first + 1});
    const CutResult result = cut_of(test::repaired(std::move(soup)), Plane{{0, 1, 0}, 0.5});
    ASSERT_EQ(result.status, Status::done);
    expect_closed(result.positive);
    expect_closed(result.negative);
    EXPECT_EQ(result.section_area, 0.875);
    if (!triangulates()) return;
    EXPECT_FALSE(result.caps_exceed_section);
    for (const auto* side : {&result.positive, &result.negative})
        EXPECT_EQ(referee::area(side->front()->to_indexed_mesh(), TriangleKind::cap), 0.875);
}

TEST_P(CrossingSections, SimpleSectionsAreCoveredOnceOrTheResultSaysSo)
{
    for (const test::NamedMesh& shape : test::closed_shapes())
        for (const test::NamedPlane& named : test::planes_for(shape.mesh, 4, 5)) {
            const CutResult result = cut_of(shape.mesh, named.plane);
            if (result.status != Status::done) continue;
            const Areas areas = areas_of(result, named.plane);
            const double tolerance = 1e-6 * result.section_area + areas.rounding;
            if (!result.caps_exceed_section) {
                EXPECT_NEAR(areas.cap, result.section_area, 2 * tolerance) << shape.name << ", " << named.name;
            }
            if (triangulates()) {
                EXPECT_FALSE(result.caps_exceed_section) << shape.name << ", " << named.name;
                EXPECT_NEAR(areas.cap, areas.wound, 2 * tolerance) << shape.name << ", " << named.name;
            }
        }
}

}  // namespace
}  // namespace kerf::core
