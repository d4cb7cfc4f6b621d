#include "viewer/sim/proxy_shape.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "viewer/sim/body_proxies.h"
#include "viewer/sim/bullet_glm.h"
#include "viewer/sim/solid.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

struct Built
{
    Solid solid;
    CollisionProxy proxy;
    std::unique_ptr<ProxyShape> shape;
};

Built build(const Mesh& mesh, ProxyKind kind, double scale = 1.0)
{
    Built built;
    const Object object = test::object_of(mesh);
    built.solid = solid_of(object.mass_properties(), object.bounds(), scale);
    built.proxy = body_proxy(object, kind);
    built.shape = std::make_unique<ProxyShape>(built.proxy, built.solid.centre, built.solid.axes, scale);
    return built;
}

// How far the shape reaches along a direction of the mesh, from the centre of mass, metres.
double reach(const Built& built, const glm::dvec3& direction)
{
    const btVector3 local = to_bullet(glm::transpose(built.solid.axes) * direction);
    return double(local.dot(built.shape->shape().localGetSupportingVertex(local)));
}

double reach_of_mesh(const Built& built, const Mesh& mesh, const glm::dvec3& direction, double scale)
{
    double far = -1e300;
    for (const Vec3f& p : mesh.arrays().positions)
        far = std::max(far, scale * glm::dot(direction, glm::dvec3(glm::vec3(p)) - built.solid.centre));
    return far;
}

TEST(ProxyShape, HullsReachAsFarAsTheMeshFromItsCentreOfMass)
{
    for (const char* name : {"asteroid", "l_step", "two_legs", "cone"}) {
        const Mesh mesh = test::shape(name);
        for (const ProxyKind kind : {ProxyKind::full_hull, ProxyKind::points}) {
            const double scale = 0.7;
            const Built built = build(mesh, kind, scale);
            for (const glm::dvec3 d : {glm::dvec3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0.6, 0.64, -0.48}}) {
                const double over = reach(built, d) - reach_of_mesh(built, mesh, d, scale);
                EXPECT_GE(over, -1e-3) << name;
                EXPECT_LE(over, 0.011) << name << ": no more than the margin";
            }
        }
    }
}

TEST(ProxyShape, BoxAndBallHoldTheMeshAndTheBoundedHullLiesInside)
{
    const Mesh mesh = test::shape("asteroid");
    for (const glm::dvec3 d : {glm::dvec3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0.6, 0.64, -0.48}}) {
        const Built box = build(mesh, ProxyKind::box), ball = build(mesh, ProxyKind::sphere);
        const Built bounded = build(mesh, ProxyKind::bounded_hull);
        EXPECT_GE(reach(box, d), reach_of_mesh(box, mesh, d, 1.0) - 1e-5);
        EXPECT_GE(reach(ball, d), reach_of_mesh(ball, mesh, d, 1.0) - 1e-5);
        EXPECT_LE(reach(bounded, d), reach_of_mesh(bounded, mesh, d, 1.0) + 0.011);
    }
}

TEST(ProxyShape, RadiusHoldsTheShape)
{
    const Mesh mesh = test::shape("l_step");
    for (const ProxyKind kind : kProxyKinds) {
        const Built built = build(mesh, kind);
        for (const glm::dvec3 d : {glm::dvec3{1, 0, 0}, {0, -1, 0}, {-1, -1, 1}, {0.6, 0.64, -0.48}})
            EXPECT_GE(built.shape->radius(), reach(built, glm::normalize(d)) - 1e-5) << proxy_name(kind);
    }
}

TEST(ProxyShape, FlatAndTinyPiecesGetABoxThatBulletCanHandle)
{
    CollisionProxy flat;
    flat.kind = ProxyKind::full_hull;
    for (const glm::vec3 p : {glm::vec3{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) flat.points.push_back(p);
    flat.box = {{0, 0, 0}, {1, 1, 0}};
    CollisionProxy nothing;
    nothing.kind = ProxyKind::full_hull;
    nothing.box = Object().bounds();
    ASSERT_TRUE(nothing.box.is_empty());
    CollisionProxy speck;
    speck.kind = ProxyKind::sphere;
    for (const CollisionProxy& proxy : {flat, nothing, speck}) {
        const ProxyShape shape(proxy, {0.5, 0.5, 0.0}, glm::dmat3(1.0), 1.0);
        btVector3 lo, hi;
        shape.shape().getAabb(btTransform::getIdentity(), lo, hi);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(hi[axis] - lo[axis], 2e-3f);
            EXPECT_LE(hi[axis] - lo[axis], 2.0f);
        }
    }
}

TEST(ProxyNames, EveryKindIsFoundByItsName)
{
    for (const ProxyKind kind : kProxyKinds) EXPECT_EQ(find_proxy(proxy_name(kind)), kind);
    EXPECT_FALSE(find_proxy("capsule"));
}

}  // namespace
}  // namespace kerf::sim
