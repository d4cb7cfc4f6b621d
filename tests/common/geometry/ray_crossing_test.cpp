#include "common/geometry/ray_crossing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/geometric.hpp>

#include "common/shapes/shapes.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

constexpr std::array<std::pair<int, bool>, 6> kDirections{
    {{0, true}, {0, false}, {1, true}, {1, false}, {2, true}, {2, false}}};

int winding(const TriangleSoup& mesh, const glm::vec3& origin, int axis, bool ascending)
{
    int sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += ray_crossing({origin, axis, ascending}, mesh.vertices[a].position, mesh.vertices[b].position,
                            mesh.vertices[c].position);
    return sum;
}

TEST(RayCrossing, CountsTriangleOnceWhichLeavesThroughItsFront)
{
    const glm::vec3 a{1, -1, -1}, b{1, 1, -1}, c{1, 0, 1};  // its front looks along +x
    EXPECT_EQ(ray_crossing({{0, 0, 0}, 0, true}, a, b, c), 1);
    EXPECT_EQ(ray_crossing({{0, 0, 0}, 0, true}, a, c, b), -1);
    EXPECT_EQ(ray_crossing({{2, 0, 0}, 0, false}, a, b, c), -1);
    EXPECT_EQ(ray_crossing({{0, 0, 0}, 0, false}, a, b, c), 0);
    EXPECT_EQ(ray_crossing({{2, 0, 0}, 0, true}, a, b, c), 0);
    EXPECT_EQ(ray_crossing({{0, 2, 0}, 0, true}, a, b, c), 0);
}

// Every ray from a lattice point runs along edges and through vertices of the surface.
TEST(RayCrossing, GivesTheWindingNumberWhenTheRayHitsEdgesAndVertices)
{
    const TriangleSoup box = shapes::box({4, 4, 4}, {4, 4, 4});
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z) {
                const int farthest = std::max({std::abs(x), std::abs(y), std::abs(z)});
                if (farthest == 2) continue;  // on the surface
                for (const auto& [axis, ascending] : kDirections)
                    EXPECT_EQ(winding(box, {x, y, z}, axis, ascending), farthest < 2 ? 1 : 0)
                        << x << " " << y << " " << z << " axis " << axis << (ascending ? " up" : " down");
            }
}

RC_GTEST_PROP(RayCrossing, AgreesWithTheDistanceFromTheCentreOfASphere, ())
{
    static const TriangleSoup sphere = shapes::icosphere(1.0f, 8);
    const auto coordinate = [] {
        return static_cast<float>(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-1500, 1501))) / 1000.0f;
    };
    const glm::vec3 p{coordinate(), coordinate(), coordinate()};
    const float radius = glm::length(p);
    RC_PRE(radius < 0.98f || radius > 1.0f);  // the faceted sphere is in between
    for (const auto& [axis, ascending] : kDirections)
        RC_ASSERT(winding(sphere, p, axis, ascending) == (radius < 1.0f ? 1 : 0));
}

TEST(RayCrossing, IsNegativeInsideASurfaceThatIsInsideOut)
{
    const TriangleSoup mesh = small_meshes::inside_out(small_meshes::cube());
    for (const auto& [axis, ascending] : kDirections)
        EXPECT_EQ(winding(mesh, {0.25f, 0.5f, 0.75f}, axis, ascending), -1);
}

}  // namespace
}  // namespace kerf::core
