#include "viewer/sim/surface_hash.h"

#include <kerf/cut.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "common/shapes/shapes.h"
#include "support/public_mesh.h"
#include "viewer/sim/back_ends.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

std::uint64_t hash_of(const Mesh& mesh)
{
    return surface_hash(test::object_of(mesh));
}

TEST(SurfaceHash, IsTheSameForEveryBackEnd)
{
    const Mesh mesh = test::shape("asteroid");
    const Plane plane = test::plane_through({0.1, 0.05, 0}, {1, 2, 3});
    std::uint64_t whole = 0, positive = 0;
    for (const std::string& name : backend_names()) {
        Object object = test::object_of(mesh, name);
        const std::uint64_t before = surface_hash(object);
        Cut result = cut(std::move(object), plane);
        ASSERT_EQ(result.count(Side::positive), 1u) << name;
        const std::uint64_t side = surface_hash(*result.one(Side::positive));
        if (whole == 0) {
            whole = before;
            positive = side;
        }
        EXPECT_EQ(before, whole) << name;
        EXPECT_EQ(side, positive) << name;
    }
    EXPECT_NE(whole, positive);
}

TEST(SurfaceHash, DoesNotDependOnTheOrderOfTriangles)
{
    const core::TriangleSoup soup = core::shapes::asteroid(500, 3);
    EXPECT_EQ(hash_of(test::mesh_of(soup)), hash_of(test::mesh_of(core::shapes::shuffled(soup, 9))));
}

TEST(SurfaceHash, SeesEveryBitOfEveryVertex)
{
    const core::TriangleSoup sphere = core::shapes::icosphere(1.0f, 2);
    core::TriangleSoup moved = sphere;
    moved.vertices[0].uv.x += 1.0f;
    EXPECT_NE(hash_of(test::mesh_of(moved)), hash_of(test::mesh_of(sphere)));
}

TEST(SurfaceHash, SeesWhichWayTrianglesFace)
{
    // A closed surface that is inside out is repaired, but not what lies in another one: it may be a cavity.
    const core::TriangleSoup hollow = core::shapes::sphere_in_sphere(1.0f, 0.5f, 2);
    core::TriangleSoup nested = hollow;
    for (std::size_t t = nested.triangles.size() / 2; t < nested.triangles.size(); ++t)
        std::swap(nested.triangles[t][0], nested.triangles[t][1]);
    EXPECT_NE(hash_of(test::mesh_of(nested)), hash_of(test::mesh_of(hollow)));
}

}  // namespace
}  // namespace kerf::sim
