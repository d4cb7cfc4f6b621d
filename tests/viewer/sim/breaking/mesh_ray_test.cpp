#include "viewer/sim/breaking/mesh_ray.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "viewer/sim/back_ends.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

class MeshRayTest : public testing::TestWithParam<std::string>
{
protected:
    // A ball of radius 1 around the origin, nearly.
    const Object ball = test::object_of(test::shape("icosphere", 5120), GetParam());
};

INSTANTIATE_TEST_SUITE_P(BackEnds, MeshRayTest, testing::ValuesIn(backend_names()), test::back_end_test_name);

}  // namespace

TEST_P(MeshRayTest, MeetsTheNearSideFirst)
{
    for (const glm::dvec3 from : {glm::dvec3(5, 0.1, 0.2), glm::dvec3(-3, 2, 1), glm::dvec3(0.1, 0.2, 9)}) {
        const std::optional<glm::dvec3> hit = first_hit(ball, {from, -from});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(glm::length(*hit), 1.0, 0.01);
        EXPECT_LT(glm::distance(*hit, glm::normalize(from)), 0.01);
    }
}

TEST_P(MeshRayTest, FromInsideItMeetsTheFarSide)
{
    const std::optional<glm::dvec3> hit = first_hit(ball, {{0.01, 0.02, 0.03}, {0, 0, -4}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->z, -1.0, 0.01);
}

TEST_P(MeshRayTest, GoesPastWhatItDoesNotMeet)
{
    EXPECT_FALSE(first_hit(ball, {{5, 0, 0}, {0, 1, 0}}));
    EXPECT_FALSE(first_hit(ball, {{5, 0, 0}, {1, 0, 0}})) << "it lies behind";
}

TEST(MeshRay, FindsWhatACutLeft)
{
    const Plane plane = test::plane_through({0, 0, 0}, {1, 0, 0});
    Cut cut = kerf::cut(test::object_of(test::shape("icosphere", 5120)), plane);
    const Object* const half = cut.piece(Side::negative, 0);
    ASSERT_NE(half, nullptr);
    const std::optional<glm::dvec3> hit = first_hit(*half, {{5, 0.1, 0.2}, {-1, 0, 0}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->x, 0.0, 1e-6) << "the cap";
}

}  // namespace kerf::sim
