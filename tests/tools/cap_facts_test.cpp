#include "tools/cap_facts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace kerf::tools {
namespace {

/// Two right triangles in a unit square of the plane z = 2, the second perhaps folded back over the first.
FlatMesh square_cap(bool folded)
{
    FlatMesh mesh;
    for (const glm::vec3 p :
         {glm::vec3{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, folded ? glm::vec3{0.5f, 0, 2} : glm::vec3{0, 1, 2}})
        mesh.vertices.push_back({p, {0, 0, 1}, {0, 0}});
    mesh.triangles = {Triangle{0, 1, 2}, Triangle{0, 2, 3}};
    mesh.groups = {{0, 2, 7, 0, TriangleKind::cap}};
    return mesh;
}

TEST(CapFacts, FlatTrianglesFaceAlongTheNormalAndKeepTheirArea)
{
    const FlatCap cap = flat_cap(square_cap(false), 7, {0, 0, 1});
    ASSERT_EQ(cap.triangles.size(), 2u);
    EXPECT_EQ(cap.points.size(), 4u);
    for (const Triangle& t : cap.triangles) {
        const glm::dvec2 p = cap.points[t[1]] - cap.points[t[0]], q = cap.points[t[2]] - cap.points[t[0]];
        EXPECT_DOUBLE_EQ(p.x * q.y - p.y * q.x, 1.0);
    }
    EXPECT_DOUBLE_EQ(unsigned_area(cap), 1.0);
}

TEST(CapFacts, OtherMaterialsAreOtherCaps)
{
    EXPECT_TRUE(flat_cap(square_cap(false), 6, {0, 0, 1}).triangles.empty());
}

TEST(CapFacts, TheSmallestAngleOfHalfASquareIsFortyFiveDegrees)
{
    EXPECT_NEAR(least_angle(flat_cap(square_cap(false), 7, {0, 0, 1})), 45.0, 1e-12);
    // The folded one has a corner (0,0), (1,1), (0.5,0) of 45 degrees and one at (1,1) of atan(1/3).
    EXPECT_NEAR(least_angle(flat_cap(square_cap(true), 7, {0, 0, 1})), std::atan(1.0 / 3.0) * 180.0 / std::acos(-1.0),
                1e-12);
}

TEST(CapFacts, OverlapIsTheAreaUnderAFold)
{
    EXPECT_DOUBLE_EQ(overlap_area(flat_cap(square_cap(false), 7, {0, 0, 1})), 0.0);
    EXPECT_NEAR(overlap_area(flat_cap(square_cap(true), 7, {0, 0, 1})), 0.25, 1e-7);
}

TEST(CapFacts, LargeCapsAreNotSearchedForOverlap)
{
    FlatCap cap;
    cap.points = {{0, 0}, {1, 0}, {0, 1}};
    cap.triangles.assign(kMostForOverlap + 1, Triangle{0, 1, 2});
    EXPECT_TRUE(std::isnan(overlap_area(cap)));
    cap.triangles.resize(kMostForOverlap);
    EXPECT_NEAR(overlap_area(cap), 0.5, 1e-12);
}

}  // namespace
}  // namespace kerf::tools
