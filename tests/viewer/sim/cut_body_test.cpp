#include "viewer/sim/cut_body.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "common/mesh/triangle_soup.h"
#include "common/support/random.h"
#include "support/public_mesh.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/bodies.h"

namespace kerf::sim {
namespace {

/// A body that was cut.
struct CutRun
{
    World world{0.0};
    CutRecord record;
    ObjectId last_id = 1;

    CutRun(const Mesh& mesh, const WorldPlane& plane, const std::string& backend, const Motion& motion = {})
    {
        Body& body = world.add(test::body_of(mesh, 1, {0, 0, 0}, motion, ProxyKind::bounded_hull, backend));
        before = body.momentum();
        mass = body.mass();
        record.number = 1;
        record.tick = 7;
        record.swipe = 3;
        cut_body(world, 1, plane, {ProxyKind::bounded_hull, false, &last_id}, record);
    }

    double mass = 0.0;
    glm::dvec3 before{0.0};
};

class CutBody : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(All, CutBody, testing::Values("baseline/remap", backend_names().front()),
                         [](const auto& backend) { return "Backend" + std::to_string(backend.index); });

TEST_P(CutBody, PiecesStandWhereTheyWereAndPartAlongTheNormal)
{
    const WorldPlane plane{glm::normalize(glm::dvec3(0.2, 1, 0.1)), {0, 0.05, 0}};
    const Motion motion{{1, 4, 0}, {0.3, -0.2, 1.0}};
    CutRun cut(test::shape("asteroid"), plane, GetParam(), motion);
    ASSERT_EQ(cut.record.status, Status::done);
    ASSERT_EQ(cut.record.pieces.size(), 2u);
    EXPECT_GT(glm::dot(cut.record.normal, plane.normal), 1.0 - 1e-6);
    const Body &above = *cut.world.bodies()[0], &below = *cut.world.bodies()[1];
    EXPECT_TRUE(cut.record.pieces[0].positive);
    for (const Body* piece : {&above, &below}) {
        EXPECT_NEAR(glm::distance(piece->pose().to_world({1, 2, 3}), glm::dvec3(1, 2, 3) + piece->pose().to_world({})),
                    0.0, 1e-5)
            << "nothing has turned";
    }
    EXPECT_GT(glm::dot(above.centre() - plane.point, plane.normal), 0.0);
    EXPECT_LT(glm::dot(below.centre() - plane.point, plane.normal), 0.0);
    EXPECT_NEAR(glm::distance(above.momentum() + below.momentum(), cut.before), 0.0, 1e-6 * cut.mass * 5);
    const double leaving = glm::dot(above.motion().velocity - below.motion().velocity, plane.normal);
    const double inherited = glm::dot(glm::cross(motion.spin, above.centre() - below.centre()), plane.normal);
    EXPECT_GT(leaving, inherited + 0.2);
}

TEST_P(CutBody, HeirsKnowTheirParentTheirSwipeAndTheirSiblings)
{
    CutRun cut(test::shape("asteroid"), {{0, 1, 0}, {0, 0.05, 0}}, GetParam());
    const Body &a = *cut.world.bodies()[0], &b = *cut.world.bodies()[1];
    EXPECT_EQ(cut.last_id, 3u);
    for (const Body* piece : {&a, &b}) {
        EXPECT_EQ(piece->identity().parent, 1u);
        EXPECT_EQ(piece->identity().last_swipe, 3u);
        EXPECT_EQ(piece->identity().birth, 7);
        EXPECT_EQ(piece->identity().origin.backend, GetParam());
    }
    EXPECT_TRUE(Body::are_siblings(a, b, 7));
    EXPECT_TRUE(Body::are_siblings(a, b, 7 + kSiblingTicks - 1));
    EXPECT_FALSE(Body::are_siblings(a, b, 7 + kSiblingTicks));
}

TEST_P(CutBody, APlaneThatMissesLeavesTheBodyAsItWas)
{
    CutRun cut(test::shape("asteroid"), {{0, 1, 0}, {0, 9, 0}}, GetParam());
    EXPECT_EQ(cut.record.status, Status::missed);
    ASSERT_EQ(cut.world.bodies().size(), 1u);
    EXPECT_EQ(cut.world.bodies()[0]->missed_swipe(), 3u);
    EXPECT_EQ(cut.world.bodies()[0]->identity().last_swipe, 0u);
    EXPECT_GT(cut.world.bodies()[0]->object().triangle_count(), 0u);
    EXPECT_EQ(cut.last_id, 1u);
}

TEST(CutBodyOfAComb, ThousandsOfPiecesDoNotFreezeTheWorld)
{
    // (The report's fan reaches from each tooth to the middle of all: its pieces are a crowd in one place.)
    if (backend_names().front() != "halfedge") GTEST_SKIP() << "caps that stay in their teeth need halfedge";
    // 2500 teeth, and a plane through the middle of them.
    const Mesh comb = test::shape("comb", 60'000);
    const Box box = comb.bounds();
    const double tip = 0.5 * double(box.hi.y - box.lo.y);
    CutRun cut(comb, {{0, 1, 0}, {0, 0.6 * tip, 0}}, backend_names().front());
    ASSERT_EQ(cut.record.status, Status::done);
    EXPECT_GT(cut.record.dropped, 500u);
    EXPECT_EQ(cut.world.bodies().size(), kMostBodies);
    EXPECT_EQ(cut.record.pieces.size(), kMostBodies);
    const auto heaviest = std::max_element(cut.record.pieces.begin(), cut.record.pieces.end(),
                                           [](const auto& a, const auto& b) { return a.mass < b.mass; });
    EXPECT_FALSE(heaviest->positive) << "the bar stays";
    for (int i = 0; i < 10; ++i) cut.world.step();
}

/// Triangles through one another, none of which hangs together with another.
Mesh loose_triangles(std::uint32_t triangles)
{
    core::Random random(3);
    core::TriangleSoup soup;
    for (std::uint32_t i = 0; i < triangles; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            core::Vertex vertex{};
            for (int axis = 0; axis < 3; ++axis) vertex.position[axis] = 1e-6f * float(random.below(2'000'000)) - 1.0f;
            soup.vertices.push_back(vertex);
        }
        soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return test::mesh_of(soup);
}

TEST(CutBodyOfASoup, PiecesInOnePlaceAreNotMoreThanPhysicsCanTake)
{
    CutRun cut(loose_triangles(800), {{0, 1, 0}, {0, 0.1, 0}}, backend_names().front());
    ASSERT_NE(cut.record.status, Status::missed);
    EXPECT_GT(cut.record.dropped, 500u);
    EXPECT_EQ(cut.record.crowded, cut.record.dropped) << "none for want of room elsewhere";
    EXPECT_GE(cut.record.pieces.size(), kMostNeighbours / 2);
    EXPECT_LE(test::overlapping_pairs(cut.world), kMostNeighbours * cut.world.bodies().size());
    // Whoever goes on cutting does not make more of them in that place.
    for (const glm::dvec3 normal : {glm::dvec3{1, 0, 0}, {0, 0, 1}, {0.6, 0.8, 0}, {0, 0.8, 0.6}}) {
        std::vector<ObjectId> ids;
        for (const auto& body : cut.world.bodies()) ids.push_back(body->id());
        for (const ObjectId id : ids) {
            CutRecord record;
            cut_body(cut.world, id, {normal, {0, 0, 0}}, {ProxyKind::bounded_hull, false, &cut.last_id}, record);
            if (record.status == Status::done || record.status == Status::open_section) {
                EXPECT_GE(record.pieces.size(), 1u);
            }
        }
        EXPECT_GE(cut.world.bodies().size(), ids.size());
        EXPECT_LE(test::overlapping_pairs(cut.world), kMostNeighbours * cut.world.bodies().size());
    }
}

}  // namespace
}  // namespace kerf::sim
