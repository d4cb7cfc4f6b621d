// What cut() promises, for every back end.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/cutting/cut.h"
#include "common/mesh/plane_frame.h"
#include "common/mesh/plane_noise.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using test::closed_shape;
using test::closed_shapes;
using test::NamedMesh;
using test::NamedPlane;

class CutContract : public testing::TestWithParam<test::NamedBackend>
{
protected:
    std::unique_ptr<Cuttable> prepare(const IndexedMesh& mesh) const
    {
        PrepareResult result = backend_->prepare(mesh);
        EXPECT_EQ(result.status, Status::done) << result.reason;
        return std::move(result.object);
    }

    std::unique_ptr<Backend> backend_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, CutContract, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

using Fragments = std::vector<std::unique_ptr<Cuttable>>;

Plane plane_through(const glm::dvec3& point, const glm::dvec3& normal)
{
    return *Plane::through(point, normal);
}

/// Everything that holds for each fragment of a cut through a closed mesh.
void expect_sound(const Fragments& fragments, const Plane& plane, bool is_positive, double noise)
{
    for (const auto& fragment : fragments) {
        const IndexedMesh mesh = fragment->to_indexed_mesh();
        EXPECT_EQ(check(mesh), "");
        EXPECT_EQ(referee::open_edges(mesh), 0u);
        EXPECT_EQ(referee::open_edges_by_position(mesh), 0u);
        EXPECT_EQ(referee::triangles_with_equal_corners(mesh), 0u);
        EXPECT_LE(referee::overhang(mesh, plane, is_positive), noise);
    }
}

/// Cuts `whole` and checks what every cut through a closed mesh keeps. `original` is the mesh that it descends from:
/// rounding is in proportion to that one, however small the piece.
void expect_good_cut(std::unique_ptr<Cuttable> object, const IndexedMesh& whole, const Plane& plane,
                     const IndexedMesh& original)
{
    const double noise = plane_noise(original.bounds().largest_coordinate());
    const double volume = referee::volume(whole), surface = referee::area(whole, TriangleKind::surface);
    const CutResult result = cut(std::move(object), plane);
    if (result.status == Status::missed) {
        const double least = -referee::overhang(whole, plane, true), most = referee::overhang(whole, plane, false);
        EXPECT_TRUE(least >= -noise || most <= noise) << "missed although both sides have something";
        ASSERT_TRUE(result.object);
        EXPECT_EQ(referee::bytes_of(result.object->to_indexed_mesh()), referee::bytes_of(whole));
        return;
    }
    ASSERT_EQ(result.status, Status::done);
    EXPECT_FALSE(result.object);
    ASSERT_EQ(result.positive.size(), 1u);
    ASSERT_EQ(result.negative.size(), 1u);
    expect_sound(result.positive, plane, true, noise);
    expect_sound(result.negative, plane, false, noise);
    EXPECT_NEAR(referee::volume(result.positive) + referee::volume(result.negative), volume,
                referee::kSumTolerance * std::abs(referee::volume(original)));
    const double surface_after = referee::area(result.positive[0]->to_indexed_mesh(), TriangleKind::surface) +
                                 referee::area(result.negative[0]->to_indexed_mesh(), TriangleKind::surface);
    EXPECT_NEAR(surface_after, surface, referee::kSumTolerance * referee::area(original));
}

TEST_P(CutContract, SidesAreClosedAndAddUpForEveryShapeAndPlane)
{
    for (const NamedMesh& shape : closed_shapes()) {
        const auto original = prepare(shape.mesh);
        const IndexedMesh whole = original->to_indexed_mesh();
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 6, 11)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            expect_good_cut(original->clone(), whole, plane.plane, shape.mesh);
        }
    }
}

TEST_P(CutContract, PiecesCanBeCutAgain)
{
    for (const NamedMesh& shape : closed_shapes()) {
        SCOPED_TRACE(shape.name);
        Fragments objects;
        objects.push_back(prepare(shape.mesh));
        test::Random random(5);
        const double whole = referee::volume(shape.mesh);
        for (int generation = 0; generation < 4; ++generation) {
            Fragments next;
            for (auto& object : objects) {
                const IndexedMesh before = object->to_indexed_mesh();
                const auto planes = test::planes_for(before, 1, random.next());
                const NamedPlane& plane = planes[random.below(static_cast<std::uint32_t>(planes.size()))];
                SCOPED_TRACE("generation " + std::to_string(generation) + ", plane " + plane.name);
                expect_good_cut(object->clone(), before, plane.plane, shape.mesh);
                CutResult result = cut(std::move(object), plane.plane);
                if (result.object) next.push_back(std::move(result.object));
                for (Fragments* side : {&result.positive, &result.negative})
                    for (auto& fragment : *side) next.push_back(std::move(fragment));
            }
            objects = std::move(next);
            EXPECT_NEAR(referee::volume(objects), whole, referee::kSumTolerance * whole);
        }
    }
}

TEST_P(CutContract, SurfaceTrianglesAreThoseOfTheFirstBackEndBitForBit)
{
    const auto reference = test::backends().front().make();
    for (const NamedMesh& shape : closed_shapes()) {
        const auto object = prepare(shape.mesh);
        const auto expected = std::move(reference->prepare(shape.mesh).object);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 3, 17)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            const CutResult a = cut(object->clone(), plane.plane), b = cut(expected->clone(), plane.plane);
            ASSERT_EQ(a.status, b.status);
            EXPECT_EQ(referee::canonical_surface(a.positive), referee::canonical_surface(b.positive));
            EXPECT_EQ(referee::canonical_surface(a.negative), referee::canonical_surface(b.negative));
            EXPECT_NEAR(a.section_area, b.section_area, 1e-9 * (1 + std::abs(b.section_area)));
            EXPECT_EQ(a.statistics.crossing_triangles, b.statistics.crossing_triangles);
        }
    }
}

TEST_P(CutContract, CrossingSurfaceIsTheSameAfterEarlierCutsAlthoughCapsDiffer)
{
    const auto reference = test::backends().front().make();
    const IndexedMesh mesh = test::closed_shape("torus");
    const Plane first = *Plane::through({0.05, 0.02, 0.01}, {1, 0.2, 0.3}),
                second = *Plane::through({0, 0, 0}, {0.1, 0.2, 1});
    CutResult a = cut(prepare(mesh), first), b = cut(std::move(reference->prepare(mesh).object), first);
    EXPECT_EQ(a.statistics.crossing_surface, a.statistics.crossing_triangles) << "there was no cap yet";
    a = cut(std::move(a.positive.front()), second);
    b = cut(std::move(b.positive.front()), second);
    EXPECT_EQ(a.statistics.crossing_surface, b.statistics.crossing_surface);
    EXPECT_LT(a.statistics.crossing_surface, a.statistics.crossing_triangles) << "the cap is crossed as well";
}

TEST_P(CutContract, TheSameCutGivesTheSameBytes)
{
    for (const NamedMesh& shape : closed_shapes()) {
        const auto first = prepare(shape.mesh), second = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 1, 3)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            const CutResult a = cut(first->clone(), plane.plane), b = cut(second->clone(), plane.plane);
            ASSERT_EQ(a.positive.size(), b.positive.size());
            for (std::size_t i = 0; i < a.positive.size(); ++i)
                EXPECT_EQ(referee::bytes_of(a.positive[i]->to_indexed_mesh()),
                          referee::bytes_of(b.positive[i]->to_indexed_mesh()));
            for (std::size_t i = 0; i < a.negative.size(); ++i)
                EXPECT_EQ(referee::bytes_of(a.negative[i]->to_indexed_mesh()),
                          referee::bytes_of(b.negative[i]->to_indexed_mesh()));
        }
    }
}

TEST_P(CutContract, FlippingThePlaneSwapsTheSides)
{
    for (const NamedMesh& shape : closed_shapes()) {
        const auto object = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 2, 23)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            const CutResult a = cut(object->clone(), plane.plane), b = cut(object->clone(), plane.plane.flipped());
            ASSERT_EQ(a.status, b.status);
            EXPECT_EQ(referee::canonical_surface(a.positive), referee::canonical_surface(b.negative));
            EXPECT_EQ(referee::canonical_surface(a.negative), referee::canonical_surface(b.positive));
        }
    }
}

TEST_P(CutContract, CuttingAFragmentByTheSamePlaneAgainMisses)
{
    for (const NamedMesh& shape : closed_shapes()) {
        const auto object = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 2, 29)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            CutResult result = cut(object->clone(), plane.plane);
            for (Fragments* side : {&result.positive, &result.negative})
                for (auto& fragment : *side) EXPECT_EQ(cut(std::move(fragment), plane.plane).status, Status::missed);
        }
    }
}

TEST_P(CutContract, AMissedObjectComesBackUnharmed)
{
    const IndexedMesh& mesh = closed_shape("icosphere");
    for (const Plane& plane : {plane_through({0, 0, 5}, {0, 0, 1}), plane_through({0, 0, -5}, {0, 0, 1})}) {
        auto object = prepare(mesh);
        const auto before = referee::bytes_of(object->to_indexed_mesh());
        const CutResult result = cut(std::move(object), plane);
        EXPECT_EQ(result.status, Status::missed);
        ASSERT_TRUE(result.object);
        EXPECT_EQ(referee::bytes_of(result.object->to_indexed_mesh()), before);
    }
}

TEST_P(CutContract, AMissSaysWhereTheObjectLiesAndHasNoSection)
{
    for (const NamedMesh& shape : closed_shapes()) {
        SCOPED_TRACE(shape.name);
        // Beside the object, and through a corner of its bounds where it has none itself.
        const Box bounds = shape.mesh.bounds();
        const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, 3));
        double least = INFINITY, most = -INFINITY;
        for (const Vertex& v : shape.mesh.vertices) {
            const double along = glm::dot(normal, glm::dvec3(v.position));
            least = std::min(least, along);
            most = std::max(most, along);
        }
        const double gap = 1e-3 * glm::distance(glm::dvec3(bounds.lo), glm::dvec3(bounds.hi));
        for (const auto& [offset, side] :
             {std::pair{least - gap, Side::positive}, std::pair{most + gap, Side::negative}}) {
            const Plane plane{normal, offset};
            const CutResult result = cut(prepare(shape.mesh), plane),
                            flipped = cut(prepare(shape.mesh), plane.flipped());
            ASSERT_EQ(result.status, Status::missed);
            EXPECT_EQ(result.side_of_object, side);
            EXPECT_EQ(flipped.side_of_object, opposite(side));
            EXPECT_EQ(result.section_area, 0.0);
        }
    }
}

TEST_P(CutContract, TouchingAFaceFromOutsideMisses)
{
    for (const double z : {0.5, -0.5}) {
        const CutResult result = cut(prepare(closed_shape("cube")), plane_through({0, 0, z}, {0, 0, 1}));
        EXPECT_EQ(result.status, Status::missed);
        EXPECT_EQ(result.side_of_object, z > 0.0 ? Side::negative : Side::positive);
    }
}

TEST_P(CutContract, NothingIsAnInvalidMesh)
{
    const CutResult result = cut(nullptr, Plane{});
    EXPECT_EQ(result.status, Status::invalid_mesh);
    EXPECT_EQ(result.object, nullptr);
}

TEST_P(CutContract, AnInvalidPlaneLeavesTheObjectAlone)
{
    Plane plane;
    plane.normal = {0, 0, 2};
    EXPECT_EQ(cut(prepare(closed_shape("cube")), plane).status, Status::invalid_argument);
    plane.normal = {0, 0, NAN};
    const CutResult result = cut(prepare(closed_shape("cube")), plane);
    EXPECT_EQ(result.status, Status::invalid_argument);
    EXPECT_TRUE(result.object);
}

TEST_P(CutContract, ABrokenMeshIsRefusedWithAReason)
{
    IndexedMesh mesh = closed_shape("cube");
    mesh.triangles[3][1] = 1000;
    const PrepareResult result = backend_->prepare(mesh);
    EXPECT_EQ(result.status, Status::invalid_mesh);
    EXPECT_FALSE(result.object);
    EXPECT_NE(result.reason, "");
}

TEST_P(CutContract, AConvexCapCoversTheSection)
{
    const CutResult result = cut(prepare(closed_shape("grid_cube")), plane_through({0, 0, 0.1}, {0, 0, 1}));
    ASSERT_EQ(result.status, Status::done);
    EXPECT_NEAR(result.section_area, 4.0, 1e-12);
    EXPECT_EQ(result.statistics.section_loops, 1u);
    for (const auto* side : {&result.positive, &result.negative}) {
        const IndexedMesh mesh = side->front()->to_indexed_mesh();
        EXPECT_NEAR(referee::area(mesh, TriangleKind::cap), 4.0, 1e-6);
    }
}

TEST_P(CutContract, CapNormalsFaceOutAndUvIsPlanar)
{
    const Plane plane = plane_through({0.1, 0, 0.05}, {1, 2, 3});
    const CutResult result = cut(prepare(closed_shape("icosphere")), plane);
    ASSERT_EQ(result.status, Status::done);
    const PlaneFrame frame = PlaneFrame::of(plane.normal);
    for (const auto* side : {&result.positive, &result.negative}) {
        const glm::dvec3 outward = side == &result.negative ? plane.normal : -plane.normal;
        const IndexedMesh mesh = side->front()->to_indexed_mesh();
        ASSERT_EQ(mesh.groups.back().kind, TriangleKind::cap);
        EXPECT_EQ(mesh.materials[mesh.groups.back().material].name, "cap");
        for (std::uint32_t t = mesh.groups.back().first; t < mesh.triangles.size(); ++t) {
            EXPECT_EQ(mesh.sources[t], kNoSource);
            std::array<glm::dvec3, 3> p;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vertex& v = mesh.vertices[mesh.triangles[t][i]];
                p[i] = glm::dvec3(v.position);
                EXPECT_NEAR(glm::length(glm::dvec3(v.normal) - outward), 0, 1e-6);
                EXPECT_NEAR(double(v.uv.x), glm::dot(frame.u, p[i]), 1e-6);
                EXPECT_NEAR(double(v.uv.y), glm::dot(frame.v, p[i]), 1e-6);
            }
            EXPECT_GT(glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), outward), 0);
        }
    }
}

TEST_P(CutContract, CapsNeverShareAMaterialWithTheSurfaceByAccident)
{
    IndexedMesh mesh = closed_shape("icosphere");
    mesh.materials[0].name = "cap";
    CutResult result = cut(prepare(mesh), plane_through({0, 0, 0.1}, {0, 0, 1}));
    ASSERT_EQ(result.status, Status::done);
    // And again: the second cut's cap has the material of the first.
    result = cut(std::move(result.positive[0]), plane_through({0.1, 0, 0}, {1, 0, 0}));
    ASSERT_EQ(result.status, Status::done);
    const IndexedMesh part = result.negative[0]->to_indexed_mesh();
    for (const TriangleGroup& group : part.groups)
        EXPECT_EQ(part.materials[group.material].name, group.kind == TriangleKind::cap ? "cap.1" : "cap");
}

TEST_P(CutContract, EachPieceHasTheLoopsThatBoundIt)
{
    CutOptions options;
    options.split_components = true;
    const CutResult result = cut(prepare(closed_shape("two_spheres")), plane_through({0, 0.1, 0}, {0, 1, 0}), options);
    ASSERT_EQ(result.positive.size(), 2u);
    for (const auto* side : {&result.positive, &result.negative})
        for (const auto& piece : *side) EXPECT_EQ(piece->section_loops().size(), 1u);
}

TEST_P(CutContract, CapsCanBeLeftOut)
{
    CutOptions options;
    options.build_caps = false;
    const CutResult result = cut(prepare(closed_shape("icosphere")), plane_through({0, 0, 0.1}, {0, 0, 1}), options);
    ASSERT_EQ(result.status, Status::done);
    const IndexedMesh mesh = result.positive[0]->to_indexed_mesh();
    EXPECT_EQ(referee::area(mesh, TriangleKind::cap), 0.0);
    EXPECT_GT(referee::open_edges(mesh), 0u);
}

TEST_P(CutContract, AFaceInThePlaneStaysOnTheSideOfItsSolid)
{
    // The sponge's tunnels have faces in the plane z = 1/6 (side 1, level 1): the plane runs along them.
    const IndexedMesh& mesh = closed_shape("menger_sponge");
    const double z = double(mesh.bounds().hi.z) / 3;
    const CutResult result = cut(prepare(mesh), plane_through({0, 0, z}, {0, 0, 1}));
    ASSERT_EQ(result.status, Status::done);
    const double whole = referee::volume(mesh);
    EXPECT_NEAR(referee::volume(result.positive) + referee::volume(result.negative), whole,
                referee::kSumTolerance * whole);
    for (const auto* side : {&result.positive, &result.negative}) {
        const bool is_positive = side == &result.positive;
        const IndexedMesh part = side->front()->to_indexed_mesh();
        for (const TriangleGroup& group : part.groups)
            for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
                bool in_plane = group.kind == TriangleKind::surface;
                for (const std::uint32_t v : part.triangles[t])
                    in_plane = in_plane && double(part.vertices[v].position.z) == z;
                if (!in_plane) continue;
                const glm::vec3 n = part.vertices[part.triangles[t][0]].normal;
                EXPECT_EQ(n.z < 0, is_positive);
            }
    }
}

TEST_P(CutContract, ClonesAreIndependent)
{
    const auto original = prepare(closed_shape("torus"));
    const auto before = referee::bytes_of(original->to_indexed_mesh());
    auto copy = original->clone();
    EXPECT_EQ(referee::bytes_of(copy->to_indexed_mesh()), before);
    const CutResult result = cut(std::move(copy), plane_through({0, 0, 0}, {1, 1, 0.3}));
    ASSERT_EQ(result.status, Status::done);
    EXPECT_EQ(referee::bytes_of(original->to_indexed_mesh()), before);
}

TEST_P(CutContract, DrawViewShowsEveryTriangleOnce)
{
    CutResult result = cut(prepare(closed_shape("torus")), plane_through({0, 0, 0.01}, {0.2, 0.1, 1}));
    ASSERT_EQ(result.status, Status::done);
    for (const auto* side : {&result.positive, &result.negative}) {
        Cuttable& fragment = *side->front();
        const DrawView view = fragment.draw_view();
        const IndexedMesh mesh = fragment.to_indexed_mesh();
        std::vector<std::array<std::array<float, 9>, 1>> drawn, expected;
        const auto corners = [](const Vertex& a, const Vertex& b, const Vertex& c) {
            std::array<float, 9> p{};
            std::size_t i = 0;
            for (const Vertex* v : {&a, &b, &c})
                for (int axis = 0; axis < 3; ++axis) p[i++] = v->position[axis];
            return p;
        };
        for (const DrawRange& range : view.ranges)
            for (std::uint32_t i = range.first_index; i < range.first_index + range.index_count; i += 3)
                drawn.push_back({corners(view.vertices[view.indices[i]], view.vertices[view.indices[i + 1]],
                                         view.vertices[view.indices[i + 2]])});
        for (const Triangle& t : mesh.triangles)
            expected.push_back({corners(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]])});
        std::sort(drawn.begin(), drawn.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(drawn, expected);
        EXPECT_FALSE(view.new_index_bytes.empty());
    }
    // Fragments may share their buffers, so marking one may mark the other.
    for (const auto* side : {&result.positive, &result.negative}) {
        Cuttable& fragment = *side->front();
        fragment.mark_uploaded(fragment.draw_view());
        EXPECT_TRUE(fragment.draw_view().new_index_bytes.empty());
        EXPECT_TRUE(fragment.draw_view().new_vertex_bytes.empty());
    }
}

TEST_P(CutContract, MassIsThatOfTheSolid)
{
    const CutResult result = cut(prepare(closed_shape("cube")), plane_through({0, 0, 0.25}, {0, 0, 1}));
    ASSERT_EQ(result.status, Status::done);
    const MassProperties mass = result.positive[0]->mass_properties();
    EXPECT_NEAR(mass.volume, 0.25, 1e-7);
    EXPECT_NEAR(mass.centre.z, 0.375, 1e-7);
    EXPECT_NEAR(mass.inertia[2][2], 0.25 * (1.0 + 1.0) / 12, 1e-7);
}

TEST_P(CutContract, SectionLoopsRunAroundTheMaterial)
{
    // A pipe cut across: an outer loop counter-clockwise and a hole clockwise.
    const CutResult result = cut(prepare(closed_shape("pipe")), plane_through({0, 0, 0.1}, {0, 0, 1}));
    ASSERT_EQ(result.status, Status::done);
    const auto loops = result.negative[0]->section_loops();
    ASSERT_EQ(loops.size(), 2u);
    std::vector<double> areas;
    for (const SectionLoop& loop : loops) {
        EXPECT_TRUE(loop.closed);
        double twice = 0;
        for (std::size_t i = 0; i < loop.points.size(); ++i) {
            const glm::vec3 a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
            twice += double(a.x) * double(b.y) - double(b.x) * double(a.y);
        }
        areas.push_back(twice / 2);
    }
    std::sort(areas.begin(), areas.end());
    EXPECT_LT(areas[0], 0);
    EXPECT_GT(areas[1], 0);
    EXPECT_NEAR(areas[0] + areas[1], result.section_area, 1e-6);
}

TEST_P(CutContract, OpenMeshesKeepTheirSidesAndSaySo)
{
    for (const NamedMesh& shape : test::open_shapes()) {
        const auto object = prepare(shape.mesh);
        const double surface = referee::area(shape.mesh);
        bool some_open = false;
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 6, 31)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            const CutResult result = cut(object->clone(), plane.plane);
            if (result.status == Status::missed) continue;
            EXPECT_EQ(result.status == Status::open_section, result.statistics.open_chains > 0);
            some_open |= result.status == Status::open_section;
            double sum = 0;
            for (const auto* side : {&result.positive, &result.negative})
                for (const auto& fragment : *side) {
                    const IndexedMesh mesh = fragment->to_indexed_mesh();
                    EXPECT_EQ(check(mesh), "");
                    EXPECT_LE(referee::overhang(mesh, plane.plane, side == &result.positive),
                              plane_noise(shape.mesh.bounds().largest_coordinate()));
                    sum += referee::area(mesh, TriangleKind::surface);
                }
            EXPECT_NEAR(sum, surface, referee::kSumTolerance * surface);
        }
        EXPECT_TRUE(some_open) << shape.name;
    }
}

// Pieces
// ---------------------------------------------------------------------------------------------------------------

struct PieceCase
{
    std::string shape;
    glm::dvec3 point, normal;
    std::size_t positive, negative;
};

TEST_P(CutContract, SidesFallApartIntoTheirPieces)
{
    CutOptions options;
    options.split_components = true;
    const std::vector<PieceCase> cases{
        {"icosphere", {0, 0, 0.1}, {0, 0, 1}, 1, 1},
        {"torus", {0, 0, 0.01}, {0, 0, 1}, 1, 1},  // an annulus
        {"torus", {0.01, 0, 0}, {1, 0, 0}, 1, 1},  // two discs, but each side hangs together
        {"torus", {0, 0.8, 0}, {0, 1, 0}, 1, 1},   // the top of the ring comes off
        {"pipe", {0.01, 0, 0}, {1, 0, 0}, 1, 1},   // two half pipes
        {"sphere_in_sphere", {0, 0, 0.1}, {0, 0, 1}, 1, 1},
        {"sphere_in_sphere", {0, 0, 0.7}, {0, 0, 1}, 1, 1},  // the cavity goes below, uncut
        {"two_spheres", {1.5, 0, 0}, {1, 0, 0}, 1, 1},       // between them: no section at all
        {"two_spheres", {0, 0.1, 0}, {0, 1, 0}, 2, 2},
        {"overlapping_spheres", {0, 0, 0.05}, {0, 0, 1}, 2, 2},
        {"comb", {0, 0, 0.01}, {0, 0, 1}, 1, 1},
    };
    for (const PieceCase& c : cases) {
        SCOPED_TRACE(c.shape + " along " + std::to_string(c.normal.x) + " " + std::to_string(c.normal.y) + " " +
                     std::to_string(c.normal.z));
        const IndexedMesh& mesh = closed_shape(c.shape);
        const Plane plane = plane_through(c.point, c.normal);
        const CutResult result = cut(prepare(mesh), plane, options);
        ASSERT_EQ(result.status, Status::done);
        EXPECT_EQ(result.positive.size(), c.positive);
        EXPECT_EQ(result.negative.size(), c.negative);
        const double noise = plane_noise(mesh.bounds().largest_coordinate()), whole = referee::volume(mesh);
        expect_sound(result.positive, plane, true, noise);
        expect_sound(result.negative, plane, false, noise);
        EXPECT_NEAR(referee::volume(result.positive) + referee::volume(result.negative), whole,
                    referee::kSumTolerance * whole);
    }
}

TEST_P(CutContract, TheTeethOfACombComeOffOneByOne)
{
    const IndexedMesh& mesh = closed_shape("comb");
    CutOptions options;
    options.split_components = true;
    // Just below the tips: every tooth is cut.
    const double y = double(mesh.bounds().hi.y) - 0.05 * double(mesh.bounds().hi.y - mesh.bounds().lo.y);
    const CutResult result = cut(prepare(mesh), plane_through({0, y, 0}, {0, 1, 0}), options);
    ASSERT_EQ(result.status, Status::done);
    EXPECT_EQ(result.positive.size(), 5u);
    EXPECT_EQ(result.negative.size(), 1u);
    EXPECT_EQ(result.statistics.section_loops, 5u);
    for (const auto& tooth : result.positive) {
        EXPECT_EQ(referee::open_edges(tooth->to_indexed_mesh()), 0u);
        EXPECT_GT(tooth->mass_properties().volume, 0.0);
    }
}

TEST_P(CutContract, PiecesTogetherAreTheSide)
{
    CutOptions apart;
    apart.split_components = true;
    for (const NamedMesh& shape : closed_shapes()) {
        const auto object = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 2, 37)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            const CutResult whole = cut(object->clone(), plane.plane),
                            pieces = cut(object->clone(), plane.plane, apart);
            ASSERT_EQ(whole.status, pieces.status);
            EXPECT_EQ(referee::canonical_surface(whole.positive), referee::canonical_surface(pieces.positive));
            EXPECT_EQ(referee::canonical_surface(whole.negative), referee::canonical_surface(pieces.negative));
            for (const Fragments* side : {&pieces.positive, &pieces.negative})
                for (const auto& piece : *side) EXPECT_EQ(referee::open_edges(piece->to_indexed_mesh()), 0u);
        }
    }
}

/// A mesh of positions alone.
IndexedMesh mesh_of(const std::vector<glm::vec3>& positions, const std::vector<Triangle>& triangles)
{
    TriangleSoup soup;
    for (const glm::vec3& p : positions) soup.vertices.push_back({p, {0, 1, 0}, {}});
    soup.triangles.assign(triangles.begin(), triangles.end());
    return test::repaired(std::move(soup));
}

TEST_P(CutContract, ATipThatVanishesWhollyIsMissed)
{
    // From 2^23 on the floats are whole numbers: the three cut points below the tip are one.
    const float o = 8388708.0f;
    const IndexedMesh spike =
        mesh_of({{o, o + 16, o}, {o + 1, o - 1000, o}, {o - 1, o - 1000, o + 1}, {o - 1, o - 1000, o - 1}},
                {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
    const CutResult result = cut(prepare(spike), plane_through({0, o, 0}, {0, 1, 0}));
    EXPECT_EQ(result.status, Status::missed);
    ASSERT_TRUE(result.object);
    EXPECT_EQ(result.object->to_indexed_mesh().triangles.size(), 4u);
    // And it can be cut elsewhere.
    EXPECT_EQ(cut(prepare(spike), plane_through({0, o - 500, 0}, {0, 1, 0})).status, Status::done);
}

TEST_P(CutContract, TwoTrianglesBackToBackHaveNoSection)
{
    const IndexedMesh pillow = mesh_of({{0, 1, 0}, {1, -1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 2, 1}});
    for (const bool split : {false, true}) {
        CutOptions options;
        options.split_components = split;
        const CutResult result = cut(prepare(pillow), plane_through({0, 0, 0}, {0, 1, 0}), options);
        ASSERT_EQ(result.status, Status::done);
        EXPECT_EQ(result.statistics.section_loops, 0u);
        ASSERT_EQ(result.positive.size(), 1u);
        ASSERT_EQ(result.negative.size(), 1u);
        for (const Fragments* side : {&result.positive, &result.negative}) {
            const IndexedMesh mesh = side->front()->to_indexed_mesh();
            EXPECT_EQ(check(mesh), "");
            EXPECT_EQ(referee::open_edges(mesh), 0u);
            for (const TriangleGroup& group : mesh.groups) EXPECT_EQ(group.kind, TriangleKind::surface);
        }
        EXPECT_EQ(result.positive.front()->triangle_count(), 2u);
        EXPECT_EQ(result.negative.front()->triangle_count(), 4u);
    }
}

}  // namespace
}  // namespace kerf::core
