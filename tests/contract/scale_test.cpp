// The same mesh at other sizes and other places: what stays the same bit for bit, and what is promised where floats are
// too coarse for the mesh.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/cutting/cut.h"
#include "common/mesh/coordinate_grain.h"
#include "common/proxy/collision_proxy.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using test::NamedMesh;

class Scale : public testing::TestWithParam<test::NamedBackend>
{
protected:
    std::unique_ptr<Backend> backend_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, Scale, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

IndexedMesh scaled(IndexedMesh mesh, float factor)
{
    for (Vertex& v : mesh.vertices) v.position *= factor;
    return mesh;
}

/// Scaled and moved before it is rounded to float, as a program would that keeps its world in metres.
TriangleSoup placed(TriangleSoup soup, double factor, double offset)
{
    for (Vertex& v : soup.vertices)
        v.position = glm::vec3(glm::dvec3(v.position) * factor + glm::dvec3(offset, -0.5 * offset, 0.25 * offset));
    return soup;
}

/// No vertex so near zero that a smaller float for it could not be exact: multiples of 2^-20 up to 2^6.
IndexedMesh on_a_lattice(IndexedMesh mesh)
{
    for (Vertex& v : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis)
            v.position[axis] = float(std::nearbyint(double(v.position[axis]) * 0x1p20) * 0x1p-20) + 0.0f;
    return mesh;
}

TEST_P(Scale, ByPowersOfTwoGivesTheSameTrianglesAtOtherPlaces)
{
    for (const NamedMesh& shape : test::closed_shapes()) {
        const IndexedMesh mesh = on_a_lattice(shape.mesh);
        for (const test::NamedPlane& plane : test::planes_for(mesh, 1, 5)) {
            const CutResult expected = cut(backend_->prepare(mesh).object, plane.plane);
            for (const int exponent : {-20, -10, 10, 20}) {
                SCOPED_TRACE(shape.name + ", " + plane.name + ", 2^" + std::to_string(exponent));
                const float factor = std::ldexp(1.0f, exponent);
                Plane moved = plane.plane;
                moved.offset *= double(factor);
                const CutResult result = cut(backend_->prepare(scaled(mesh, factor)).object, moved);
                ASSERT_EQ(result.status, expected.status);
                ASSERT_EQ(result.statistics.crossing_triangles, expected.statistics.crossing_triangles);
                ASSERT_EQ(result.statistics.section_loops, expected.statistics.section_loops);
                ASSERT_EQ(result.section_area, expected.section_area * double(factor) * double(factor));
                for (const auto& [a, b] :
                     {std::pair{&expected.positive, &result.positive}, {&expected.negative, &result.negative}}) {
                    ASSERT_EQ(a->size(), b->size());
                    for (std::size_t i = 0; i < a->size(); ++i) {
                        const IndexedMesh p = (*a)[i]->to_indexed_mesh(), q = (*b)[i]->to_indexed_mesh();
                        ASSERT_EQ(p.triangles, q.triangles);
                        ASSERT_EQ(p.points, q.points);
                        ASSERT_EQ(p.sources, q.sources);
                        for (std::size_t v = 0; v < p.vertices.size(); ++v) {
                            ASSERT_EQ(p.vertices[v].position * factor, q.vertices[v].position);
                            ASSERT_EQ(p.vertices[v].normal, q.vertices[v].normal);
                        }
                    }
                }
            }
        }
    }
}

TEST_P(Scale, ByPowersOfTwoGivesTheSameHulls)
{
    for (const char* name : {"box", "icosphere", "comb"})
        for (const float offset : {0.0f, 3e4f}) {
            IndexedMesh mesh = on_a_lattice(test::repaired(*shapes::make(name, 60, 1)));
            for (Vertex& v : mesh.vertices) v.position.x += offset;
            const auto object = backend_->prepare(mesh).object;
            for (const ProxyKind kind : {ProxyKind::full_hull, ProxyKind::bounded_hull}) {
                const CollisionProxy hull = collision_proxy(*object, kind);
                EXPECT_EQ(hull.faces.empty(), kind == ProxyKind::bounded_hull);
                EXPECT_FALSE(hull_faces(hull.points).empty());
                for (const int exponent : {-100, -60, -20, 20, 60, 85, 90, 95, 100}) {
                    SCOPED_TRACE(std::string(name) + " at " + std::to_string(offset) + ", 2^" +
                                 std::to_string(exponent) + ", " + std::string(name_of(kind)));
                    const float factor = std::ldexp(1.0f, exponent);
                    const PrepareResult other_object = backend_->prepare(scaled(mesh, factor));
                    const CollisionProxy other = collision_proxy(*other_object.object, kind);
                    std::vector<glm::vec3> expected = hull.points;
                    for (glm::vec3& p : expected) p *= factor;
                    EXPECT_EQ(other.points, expected);
                    EXPECT_EQ(other.faces, hull.faces);
                    EXPECT_EQ(hull_faces(other.points), hull_faces(hull.points));
                }
            }
        }
}

/// Cuts through the middle; closed pieces whose volumes add up to the whole's but for what the coordinates' grain can
/// do: each vertex is off by half a grain at most, which moves the surface by as much.
void expect_sound_cuts(const Backend& backend, const IndexedMesh& mesh, std::uint64_t seed)
{
    const double volume = referee::volume(mesh), slack = coordinate_grain(mesh.bounds()) * referee::area(mesh);
    test::Random random(seed);
    const auto object = backend.prepare(mesh).object;
    ASSERT_NE(object, nullptr);
    for (int i = 0; i < 3; ++i) {
        const Plane plane = *Plane::through(mesh.bounds().centre(), random.direction());
        const CutResult result = cut(object->clone(), plane);
        ASSERT_EQ(result.status, Status::done) << "a plane through the middle";
        double sum = 0;
        for (const auto* side : {&result.positive, &result.negative})
            for (const auto& fragment : *side) {
                const IndexedMesh piece = fragment->to_indexed_mesh();
                ASSERT_EQ(check(piece), "");
                ASSERT_EQ(referee::open_edges(piece), 0u);
                ASSERT_EQ(referee::triangles_with_equal_corners(piece), 0u);
                sum += referee::volume(piece);
            }
        ASSERT_NEAR(sum, volume, 1e-6 * std::abs(volume) + slack);
    }
}

TEST_P(Scale, ByPowersOfTenGivesClosedPiecesThatAddUp)
{
    for (const char* name : {"icosphere", "torus", "comb", "sphere_in_sphere"})
        for (const double factor : {1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e12}) {
            SCOPED_TRACE(std::string(name) + " times " + std::to_string(factor));
            Repaired mesh = repair(placed(*shapes::make(name, 400, 1), factor, 0.0));
            ASSERT_EQ(mesh.error, "");
            EXPECT_FALSE(backend_->prepare(mesh.mesh).coarse_coordinates);
            expect_sound_cuts(*backend_, mesh.mesh, 3);
        }
}

TEST_P(Scale, FarFromTheOriginGivesClosedPiecesAndAWarningWhereFloatsAreTooCoarse)
{
    struct Place
    {
        std::uint32_t triangles;
        double offset;
        bool is_coarse;
    };
    // At 3e4 floats are 1/512 apart and at 1e6 1/16; a unit sphere of 400 triangles has edges of 1/5.
    for (const Place& place : {Place{400, 3e4, false}, Place{40'000, 3e4, true}, Place{400, 1e6, true}}) {
        SCOPED_TRACE(std::to_string(place.triangles) + " triangles at " + std::to_string(place.offset));
        Repaired mesh = repair(placed(*shapes::make("icosphere", place.triangles, 1), 1.0, place.offset));
        ASSERT_EQ(mesh.error, "");
        if (place.triangles > 1000 && GetParam().name != "baseline_remap" && GetParam().name != "halfedge") continue;
        EXPECT_EQ(backend_->prepare(mesh.mesh).coarse_coordinates, place.is_coarse);
        EXPECT_EQ(has_coarse_coordinates(shortest_edge(mesh.mesh->vertices, mesh.mesh->triangles), mesh.mesh->bounds()),
                  place.is_coarse);
        expect_sound_cuts(*backend_, mesh.mesh, 3);
    }
}

TEST_P(Scale, UpToTheLargestFloatGivesClosedPiecesAndProxies)
{
    constexpr float kLargest = std::numeric_limits<float>::max();
    for (const char* name : {"box", "icosphere", "torus", "comb", "sphere_in_sphere"}) {
        SCOPED_TRACE(name);
        TriangleSoup soup = *shapes::make(name, 400, 1);
        Box box;
        for (const Vertex& v : soup.vertices) box.add(v.position);
        // In two steps, so that no product is beyond the largest.
        for (Vertex& v : soup.vertices) v.position = v.position / box.largest_coordinate() * kLargest;
        Repaired mesh = repair(std::move(soup));
        ASSERT_EQ(mesh.error, "");
        ASSERT_EQ(mesh.mesh->bounds().largest_coordinate(), kLargest);
        const PrepareResult prepared = backend_->prepare(mesh.mesh);
        EXPECT_FALSE(prepared.coarse_coordinates);
        for (const ProxyKind kind :
             {ProxyKind::box, ProxyKind::sphere, ProxyKind::bounded_hull, ProxyKind::full_hull}) {
            const CollisionProxy proxy = collision_proxy(*prepared.object, kind);
            EXPECT_TRUE(std::isfinite(proxy.radius) && std::isfinite(glm::dot(glm::dvec3(proxy.centre), {1, 1, 1})));
            for (const glm::vec3& p : proxy.points) EXPECT_LE(std::abs(p.x), kLargest);
        }
        expect_sound_cuts(*backend_, mesh.mesh, 3);
    }
}

TEST(CoordinateGrain, IsTheDistanceOfNeighbouringFloats)
{
    Box box;
    EXPECT_EQ(coordinate_grain(box), 0.0);
    box.add({1.0f, -2.0f, 0.5f});
    EXPECT_EQ(coordinate_grain(box), 0x1p-22);
    box.add({0.0f, 0.0f, 30000.0f});
    EXPECT_EQ(coordinate_grain(box), 0x1p-9);
    box.add({std::numeric_limits<float>::max(), 0.0f, 0.0f});
    EXPECT_EQ(coordinate_grain(box), 0x1p104) << "the largest has no neighbour above";
}

TEST(CoordinateGrain, MakesEdgesUnderSixteenOfItCoarse)
{
    Box box;
    box.add({1.0f, 0.0f, 0.0f});
    EXPECT_TRUE(has_coarse_coordinates(15.9 * 0x1p-23, box));
    EXPECT_FALSE(has_coarse_coordinates(16.0 * 0x1p-23, box));
}

}  // namespace
}  // namespace kerf::core
