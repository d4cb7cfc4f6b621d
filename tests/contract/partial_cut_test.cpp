// CutOptions::only, on every back end: what is cut is one region of the section, or one solid; what is not cut stays as it
// is, bit for bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

#include "common/cutting/cut.h"
#include "common/shapes/shapes.h"
#include "support/backends.h"
#include "support/brief.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using Fragments = std::vector<std::unique_ptr<Cuttable>>;

class PartialCut : public testing::TestWithParam<test::NamedBackend>
{
protected:
    std::unique_ptr<Cuttable> prepare(const IndexedMesh& mesh) const { return back_end_->prepare(mesh).object; }

    std::unique_ptr<Backend> back_end_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, PartialCut, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

CutOptions only_near(const glm::dvec3& point, OnlyNear::Extent extent = OnlyNear::Extent::region,
                     bool split_components = false)
{
    CutOptions options;
    options.only = OnlyNear{point, extent};
    options.split_components = split_components;
    return options;
}

double volume_of_both(const CutResult& result)
{
    return referee::volume(result.positive) + referee::volume(result.negative);
}

/// Triangles of `a` that `b` lacks: their sources.
std::multiset<std::uint32_t> sources_beyond(const std::vector<referee::SurfaceTriangle>& a,
                                            const std::vector<referee::SurfaceTriangle>& b)
{
    std::vector<referee::SurfaceTriangle> beyond;
    std::ranges::set_difference(a, b, std::back_inserter(beyond));
    std::multiset<std::uint32_t> sources;
    for (const referee::SurfaceTriangle& t : beyond) sources.insert(t.source);
    return sources;
}

std::vector<referee::SurfaceTriangle> surface_of_both(const CutResult& result)
{
    std::vector<referee::SurfaceTriangle> all = referee::canonical_surface(result.positive);
    const auto other = referee::canonical_surface(result.negative);
    all.insert(all.end(), other.begin(), other.end());
    std::ranges::sort(all);
    return all;
}

/// A point of each path of a section.
std::vector<glm::dvec3> points_on_paths(const PlaneSection& section)
{
    std::vector<glm::dvec3> points;
    for (const PlaneSection::Path& path : section.paths) {
        const auto on_path = section.points_of(path);
        points.push_back(0.5 * (glm::dvec3(on_path[0]) + glm::dvec3(on_path[on_path.size() > 1 ? 1 : 0])));
    }
    return points;
}

/// The triangles that a plane crosses: with corners strictly on both sides.
std::set<std::uint32_t> crossing_triangles(const IndexedMesh& mesh, const Plane& plane)
{
    std::set<std::uint32_t> crossing;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        bool above = false, below = false;
        for (const std::uint32_t v : mesh.triangles[i]) {
            above |= plane.signed_distance(mesh.vertices[v].position) > 0.0;
            below |= plane.signed_distance(mesh.vertices[v].position) < 0.0;
        }
        if (above && below) crossing.insert(mesh.sources[i]);
    }
    return crossing;
}

void expect_closed_pieces(const Fragments& pieces)
{
    for (const auto& piece : pieces) {
        const IndexedMesh mesh = piece->to_indexed_mesh();
        EXPECT_TRUE(referee::is_well_formed(mesh));
        EXPECT_EQ(referee::open_edges(mesh), 0u);
    }
}

TEST_P(PartialCut, ChangesNothingButTheTrianglesOfThePathsThatItCuts)
{
    std::size_t cuts = 0, refused = 0, partial = 0;
    for (const test::NamedMesh& shape : test::closed_shapes()) {
        const auto object = prepare(shape.mesh);
        const auto before = referee::canonical_surface(shape.mesh);
        const double whole = referee::volume(shape.mesh);
        for (const test::NamedPlane& plane : test::planes_for(shape.mesh, test::kBrief ? 1 : 2, 61)) {
            PlaneSection found;
            if (section(*object, plane.plane, found) == Status::missed) continue;
            const std::vector<glm::dvec3> points = points_on_paths(found);
            const std::set<std::uint32_t> crossing = crossing_triangles(shape.mesh, plane.plane);
            for (std::size_t i = 0; i < points.size(); ++i) {
                SCOPED_TRACE(shape.name + ", plane " + plane.name + ", path " + std::to_string(i));
                const CutResult result = cut(object->clone(), plane.plane, only_near(points[i]));
                if (result.status == Status::not_separated) {
                    ++refused;
                    EXPECT_EQ(referee::bytes_of(result.object->to_indexed_mesh()),
                              referee::bytes_of(object->to_indexed_mesh()));
                    continue;
                }
                ASSERT_EQ(name_of(result.status), "done");
                ++cuts;
                expect_closed_pieces(result.positive);
                expect_closed_pieces(result.negative);
                EXPECT_NEAR(volume_of_both(result), whole, referee::kSumTolerance * std::abs(whole));
                const auto after = surface_of_both(result);
                const auto gone = sources_beyond(before, after), made = sources_beyond(after, before);
                // A needle may come off and leave the triangle as it was.
                EXPECT_TRUE(
                    std::ranges::includes(std::set(made.begin(), made.end()), std::set(gone.begin(), gone.end())));
                EXPECT_TRUE(std::ranges::all_of(made, [&](std::uint32_t t) { return crossing.contains(t); }));
                if (gone.size() < crossing.size()) ++partial;
                // Its paths are of the section, whichever of their points comes first.
                for (const SectionLoop& loop : result.positive.front()->section_loops())
                    EXPECT_TRUE(std::ranges::any_of(found.paths, [&](const PlaneSection::Path& path) {
                        const auto of_path = found.points_of(path);
                        return of_path.size() == loop.points.size() &&
                               std::ranges::is_permutation(of_path, loop.points);
                    }));
            }
        }
    }
    EXPECT_GT(cuts, test::kBrief ? 100u : 200u);
    EXPECT_GT(refused, 20u);
    EXPECT_GT(partial, 50u);
}

TEST_P(PartialCut, OfAllThatIsThereIsTheWholeCut)
{
    for (const char* name : {"cube", "icosphere", "uv_sphere", "cone", "pipe", "sphere_in_sphere", "asteroid"}) {
        const IndexedMesh& mesh = test::closed_shape(name);
        const auto object = prepare(mesh);
        for (const test::NamedPlane& plane : test::planes_for(mesh, 3, 62)) {
            SCOPED_TRACE(std::string(name) + ", plane " + plane.name);
            PlaneSection found;
            if (section(*object, plane.plane, found) == Status::missed) continue;
            const CutResult whole = cut(object->clone(), plane.plane);
            const CutResult only =
                cut(object->clone(), plane.plane, only_near(glm::dvec3(0.0), OnlyNear::Extent::solid));
            EXPECT_EQ(name_of(only.status), name_of(whole.status));
            EXPECT_EQ(only.section_area, whole.section_area);
            EXPECT_EQ(referee::canonical_surface(only.positive), referee::canonical_surface(whole.positive));
            EXPECT_EQ(referee::canonical_surface(only.negative), referee::canonical_surface(whole.negative));
        }
    }
}

/// A comb of two teeth is a figure with two legs.
class PartialCutOfAComb : public PartialCut
{
protected:
    void expect_one_tooth_to_come_off(std::uint32_t count) const;
};

void PartialCutOfAComb::expect_one_tooth_to_come_off(std::uint32_t count) const
{
    const IndexedMesh comb = test::repaired(shapes::comb(count));
    const auto object = prepare(comb);
    // Across all teeth.
    const Box box = comb.bounds();
    std::optional<Plane> across;
    PlaneSection found;
    for (int axis = 0; axis < 3 && !across; ++axis)
        for (const double share : {0.25, 0.75}) {
            glm::dvec3 normal(0.0);
            normal[axis] = 1.0;
            const auto plane = Plane::through(glm::mix(glm::dvec3(box.lo), glm::dvec3(box.hi), share), normal);
            if (section(*object, *plane, found) == Status::done && found.paths.size() == count) across = plane;
        }
    ASSERT_TRUE(across);
    const CutResult pieces = cut(object->clone(), *across, [] {
        CutOptions options;
        options.split_components = true;
        return options;
    }());
    const Side of_teeth = pieces.negative.size() == count ? Side::negative : Side::positive;
    const auto side_of = [](const CutResult& result, Side side) -> const Fragments& {
        return side == Side::negative ? result.negative : result.positive;
    };
    double teeth = 0.0;
    for (const glm::dvec3& point : points_on_paths(found)) {
        const CutResult result = cut(object->clone(), *across, only_near(point));
        ASSERT_EQ(name_of(result.status), "done");
        ASSERT_EQ(result.positive.size(), 1u);
        ASSERT_EQ(result.negative.size(), 1u);
        EXPECT_EQ(result.statistics.section_loops, 1u);
        // The tooth is the piece of the whole cut that it is.
        const auto tooth = referee::canonical_surface(side_of(result, of_teeth));
        const auto all = referee::canonical_pieces(side_of(pieces, of_teeth));
        EXPECT_EQ(std::ranges::count(all, tooth), 1);
        teeth += referee::volume(side_of(result, of_teeth));
    }
    EXPECT_NEAR(teeth, referee::volume(side_of(pieces, of_teeth)), 1e-6 * teeth);
}

INSTANTIATE_TEST_SUITE_P(All, PartialCutOfAComb, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

TEST_P(PartialCutOfAComb, OneToothComesOffAndTheOthersStay)
{
    expect_one_tooth_to_come_off(5);
}

TEST_P(PartialCutOfAComb, OneLegOfTwoComesOff)
{
    expect_one_tooth_to_come_off(2);
}

TEST_P(PartialCut, OneLoopOfATorusDoesNotSeparateIt)
{
    const auto object = prepare(test::closed_shape("torus"));
    const auto before = referee::bytes_of(object->to_indexed_mesh());
    std::size_t upright = 0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.03, 0.02, 0.01);
        normal[axis] = 1.0;
        const Plane plane = *Plane::through({0.01, 0.02, 0.03}, normal);
        PlaneSection found;
        ASSERT_EQ(section(*object, plane, found), Status::done);
        ASSERT_EQ(found.paths.size(), 2u);
        CutResult result = cut(object->clone(), plane, only_near(points_on_paths(found)[0]));
        if (result.status != Status::not_separated) {
            // Level: a loop with a hole is one region.
            EXPECT_EQ(name_of(result.status), "done");
            EXPECT_EQ(result.statistics.section_loops, 2u);
            continue;
        }
        ++upright;
        ASSERT_NE(result.object, nullptr);
        EXPECT_EQ(referee::bytes_of(result.object->to_indexed_mesh()), before);
        // It can be cut as before, and of the solid both loops are cut.
        const CutResult both = cut(std::move(result.object), plane, only_near({0, 0, 0}, OnlyNear::Extent::solid));
        EXPECT_EQ(name_of(both.status), "done");
        EXPECT_EQ(both.statistics.section_loops, 2u);
    }
    EXPECT_EQ(upright, 2u);
}

TEST_P(PartialCut, OneOfSeveralSolidsIsCutAndTheOthersStayWhole)
{
    TriangleSoup left = shapes::icosphere(1.0f, 6), right = shapes::icosphere(1.0f, 5);
    for (Vertex& v : left.vertices) v.position.x -= 2.0f;
    for (Vertex& v : right.vertices) v.position.x += 2.0f;
    const IndexedMesh mesh = test::repaired(test::joined(left, right));
    const auto object = prepare(mesh);
    const Plane level = *Plane::through({0, 0, 0.01}, {0.1, 0.2, 1});
    for (const double x : {-2.0, 2.0}) {
        const CutResult result = cut(object->clone(), level, only_near({x, 0, 0.5}, OnlyNear::Extent::solid));
        ASSERT_EQ(name_of(result.status), "done");
        EXPECT_EQ(result.statistics.section_loops, 1u);
        expect_closed_pieces(result.positive);
        expect_closed_pieces(result.negative);
        // The other one is on the negative side, with all of its triangles.
        const double other = x < 0 ? 500 : 720;
        EXPECT_GE(double(result.negative.front()->triangle_count()), other);
        const CutResult pieces = cut(object->clone(), level, only_near({x, 0, 0.5}, OnlyNear::Extent::solid, true));
        EXPECT_EQ(pieces.positive.size(), 1u);
        EXPECT_EQ(pieces.negative.size(), 2u);
        EXPECT_TRUE(std::ranges::any_of(pieces.negative, [&](const auto& piece) {
            return double(piece->triangle_count()) == other && piece->section_loops().empty();
        }));
    }
}

TEST_P(PartialCut, PiecesAreConnectedAndCanBeCutAgain)
{
    std::size_t cuts = 0;
    for (const char* name : {"comb", "pipe", "menger_sponge", "spiral_wall", "two_spheres", "grid_cube"}) {
        const IndexedMesh& mesh = test::closed_shape(name);
        const auto object = prepare(mesh);
        const double whole = referee::volume(mesh);
        for (const test::NamedPlane& plane : test::planes_for(mesh, 2, 63)) {
            PlaneSection found;
            if (section(*object, plane.plane, found) == Status::missed) continue;
            const std::vector<glm::dvec3> points = points_on_paths(found);
            if (points.empty()) continue;
            for (const std::size_t i : {std::size_t(0), points.size() - 1}) {
                SCOPED_TRACE(std::string(name) + ", plane " + plane.name + ", path " + std::to_string(i));
                CutResult result =
                    cut(object->clone(), plane.plane, only_near(points[i], OnlyNear::Extent::region, true));
                if (result.status != Status::done) continue;
                ++cuts;
                double sum = 0.0;
                for (Fragments* side : {&result.positive, &result.negative})
                    for (std::unique_ptr<Cuttable>& piece : *side) {
                        const IndexedMesh before = piece->to_indexed_mesh();
                        EXPECT_EQ(referee::open_edges(before), 0u);
                        const Plane again = test::planes_for(before, 1, 64).front().plane;
                        const CutResult second = cut(std::move(piece), again);
                        if (second.status == Status::missed) {
                            sum += referee::volume(before);
                            continue;
                        }
                        expect_closed_pieces(second.positive);
                        expect_closed_pieces(second.negative);
                        sum += volume_of_both(second);
                    }
                EXPECT_NEAR(sum, whole, 2 * referee::kSumTolerance * std::abs(whole));
            }
        }
    }
    EXPECT_GT(cuts, 50u);
}

TEST_P(PartialCut, IsTheSameForAllBackEnds)
{
    const auto reference = test::backends().front().make();
    std::vector<test::NamedMesh> shapes = test::closed_shapes();
    shapes.insert(shapes.end(), test::open_shapes().begin(), test::open_shapes().end());
    for (const test::NamedMesh& shape : shapes) {
        const auto object = prepare(shape.mesh), other = reference->prepare(shape.mesh).object;
        for (const test::NamedPlane& plane : test::planes_for(shape.mesh, 1, 65)) {
            PlaneSection found;
            if (section(*object, plane.plane, found) == Status::missed) continue;
            const std::vector<glm::dvec3> points = points_on_paths(found);
            for (std::size_t i = 0; i < std::min<std::size_t>(points.size(), 3); ++i)
                for (const bool split : {false, true}) {
                    SCOPED_TRACE(shape.name + ", plane " + plane.name + ", path " + std::to_string(i));
                    const CutOptions options = only_near(points[i], OnlyNear::Extent::region, split);
                    const CutResult a = cut(object->clone(), plane.plane, options);
                    const CutResult b = cut(other->clone(), plane.plane, options);
                    ASSERT_EQ(name_of(a.status), name_of(b.status));
                    EXPECT_EQ(a.section_area, b.section_area);
                    for (const auto& [ours, theirs] :
                         {std::pair(&a.positive, &b.positive), std::pair(&a.negative, &b.negative)}) {
                        auto pieces = referee::canonical_pieces(*ours), expected = referee::canonical_pieces(*theirs);
                        std::ranges::sort(pieces);
                        std::ranges::sort(expected);
                        EXPECT_EQ(pieces, expected);
                    }
                }
        }
    }
}

TEST_P(PartialCut, RefusesAPointThatIsNone)
{
    const auto object = prepare(test::closed_shape("cube"));
    const CutResult result = cut(object->clone(), *Plane::through({0, 0, 0}, {0, 0, 1}),
                                 only_near({0, std::numeric_limits<double>::quiet_NaN(), 0}));
    EXPECT_EQ(result.status, Status::invalid_argument);
    EXPECT_NE(result.object, nullptr);
}

}  // namespace
}  // namespace kerf::core
