#include "viewer/sim/surface_hash.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "back_ends/back_ends.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "viewer/sim/back_ends.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

std::uint64_t hash_of(IndexedMesh mesh, const std::string& backend = "baseline/remap")
{
    return surface_hash(*make_back_end(backend)->prepare(std::move(mesh)).object);
}

TEST(SurfaceHash, IsTheSameForEveryBackEnd)
{
    const IndexedMesh mesh = *test::shape("asteroid");
    const Plane plane = *Plane::through({0.1, 0.05, 0}, {1, 2, 3});
    std::uint64_t whole = 0, positive = 0;
    for (const std::string& name : backend_names()) {
        std::unique_ptr<Cuttable> object = std::move(make_back_end(name)->prepare(mesh).object);
        const std::uint64_t before = surface_hash(*object);
        const CutResult result = cut(std::move(object), plane);
        const std::uint64_t side = surface_hash(*result.positive.front());
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
    const TriangleSoup soup = shapes::asteroid(500, 3);
    EXPECT_EQ(hash_of(*repair(soup).mesh), hash_of(*repair(shapes::shuffled(soup, 9)).mesh));
}

TEST(SurfaceHash, SeesEveryBitOfEveryVertex)
{
    const IndexedMesh mesh = *test::shape("icosphere", 80);
    const std::uint64_t original = hash_of(mesh);
    IndexedMesh moved = mesh;
    moved.vertices[0].uv.x += 1.0f;
    EXPECT_NE(hash_of(moved), original);
    IndexedMesh turned = mesh;
    for (Triangle& t : turned.triangles) std::swap(t[0], t[1]);
    EXPECT_NE(hash_of(turned), original);
}

}  // namespace
}  // namespace kerf::sim
