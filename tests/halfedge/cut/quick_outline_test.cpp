// The quick way to an outline and that of a cut are one, bit for bit, and of a large closed mesh all planes that are tried
// go the quick way: also those through vertices, along edges and in faces.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/shapes/shapes.h"
#include "halfedge/cut/outline.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/fixtures.h"
#include "support/random_case.h"

namespace kerf::core::halfedge {
namespace {

/// Bytes, not values: 0 and -0 are two.
template <class T>
std::string bytes_of(const std::vector<T>& values)
{
    static_assert(std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

void expect_equal(const PlaneSection& quick, const PlaneSection& of_cut)
{
    EXPECT_EQ(quick.status, of_cut.status);
    EXPECT_EQ(quick.crossing_triangles, of_cut.crossing_triangles);
    EXPECT_TRUE(bytes_of(quick.points) == bytes_of(of_cut.points));
    EXPECT_TRUE(bytes_of(quick.ends) == bytes_of(of_cut.ends));
    ASSERT_EQ(quick.end_streams.size(), of_cut.end_streams.size());
    for (std::size_t i = 0; i < quick.end_streams.size(); ++i)
        EXPECT_TRUE(bytes_of(quick.end_streams[i].values) == bytes_of(of_cut.end_streams[i].values));
    ASSERT_EQ(quick.edges.size(), of_cut.edges.size());
    for (std::size_t i = 0; i < quick.edges.size(); ++i) {
        EXPECT_EQ(quick.edges[i].source, of_cut.edges[i].source);
        EXPECT_EQ(quick.edges[i].material, of_cut.edges[i].material);
    }
    ASSERT_EQ(quick.paths.size(), of_cut.paths.size());
    for (std::size_t i = 0; i < quick.paths.size(); ++i) {
        const PlaneSection::Path &a = quick.paths[i], &b = of_cut.paths[i];
        EXPECT_EQ(std::tie(a.first_point, a.point_count, a.first_edge, a.edge_count, a.solid, a.closed),
                  std::tie(b.first_point, b.point_count, b.first_edge, b.edge_count, b.solid, b.closed));
    }
}

/// Sections of one object, by both ways.
class BothWays
{
public:
    explicit BothWays(const IndexedMesh& mesh) : object_(std::move(make_back_end()->prepare(mesh).object)) {}

    /// Whether the quick way is one for this plane. Misses count as none.
    bool go(const Plane& plane)
    {
        const auto& fragment = dynamic_cast<const Fragment&>(*object_);
        const Universe& u = fragment.universe();
        std::uint64_t nodes = 0;
        missed_ = missed_side(u, fragment.shells(), plane, workspace_.waiting_nodes, nodes).has_value();
        if (missed_) return false;
        PlaneSection quick, of_cut;
        quick.wants_ends = of_cut.wants_ends = true;
        if (!workspace_.quick_outline.find(u, fragment.shells(), plane, quick)) {
            EXPECT_TRUE(quick.points.empty() && quick.edges.empty() && quick.paths.empty() && quick.ends.empty());
            return false;
        }
        find_outline_as_a_cut(u, fragment.shells(), plane, workspace_, of_cut);
        expect_equal(quick, of_cut);
        return true;
    }
    bool missed() const { return missed_; }

private:
    std::unique_ptr<Cuttable> object_;
    CutWorkspace workspace_;
    bool missed_ = false;
};

TEST(QuickOutline, IsThatOfACutForAnyMeshAndPlane)
{
    test::Random random(1);
    std::size_t quick = 0, all = 0;
    for (const auto* shapes : {&test::closed_shapes(), &test::open_shapes()})
        for (const test::NamedMesh& shape : *shapes) {
            IndexedMesh moved = shape.mesh;
            test::move(moved, test::any_motion(random));
            for (const IndexedMesh& mesh : {shape.mesh, moved}) {
                BothWays ways(mesh);
                for (int i = 0; i < 100; ++i) {
                    SCOPED_TRACE(shape.name + ", plane " + std::to_string(i));
                    quick += ways.go(test::some_plane(mesh, random)) ? 1 : 0;
                    all += ways.missed() ? 0 : 1;
                }
            }
        }
    // Others: open meshes whose holes the plane meets, and slivers.
    EXPECT_GT(quick, all * 4 / 5);
}

TEST(QuickOutline, TakesAllPlanesThroughVerticesAlongEdgesAndInFaces)
{
    const IndexedMesh mesh = test::repaired(shapes::asteroid(20'000, 1));
    BothWays ways(mesh);
    test::Random random(2);
    const auto corner = [&](Index triangle, std::size_t i) {
        return glm::dvec3(mesh.vertices[mesh.triangles[triangle][i]].position);
    };
    // How many corners of its first triangle the plane passes.
    for (const std::size_t of_first : {1u, 2u, 3u}) {
        SCOPED_TRACE(of_first);
        std::size_t quick = 0, all = 0;
        for (int i = 0; i < 300; ++i) {
            std::array<glm::dvec3, 3> p;
            const Index first = random.below(static_cast<Index>(mesh.triangles.size()));
            for (std::size_t c = 0; c < 3; ++c)
                p[c] = corner(c < of_first ? first : random.below(static_cast<Index>(mesh.triangles.size())), c);
            const auto plane = Plane::through(p[0], glm::cross(p[1] - p[0], p[2] - p[0]));
            if (!plane) continue;
            quick += ways.go(*plane) ? 1 : 0;
            all += ways.missed() ? 0 : 1;
        }
        EXPECT_GE(all, 200u);
        EXPECT_EQ(quick, all);
    }
}

TEST(QuickOutline, TakesPlanesInWhichWholeRowsOfEdgesLie)
{
    const IndexedMesh grid = test::closed_shape("grid_cube"), globe = test::repaired(shapes::uv_sphere(1.0f, 64, 32)),
                      ring = test::repaired(shapes::torus(1.0f, 0.4f, 64, 32));
    for (const IndexedMesh* shape : {&grid, &globe, &ring}) {
        BothWays ways(*shape);
        for (const glm::dvec3& normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
            EXPECT_TRUE(ways.go(*Plane::through(shape->bounds().centre(), normal))) << shape->triangles.size();
    }
}

}  // namespace
}  // namespace kerf::core::halfedge
