#include "viewer/sim/blade_probe.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/geometric.hpp>

#include "common/shapes/shapes.h"
#include "common/support/random.h"
#include "support/public_mesh.h"
#include "viewer/sim/bodies.h"
#include "viewer/sim/camera.h"

namespace kerf::sim {
namespace {

const glm::dvec3 kEye = Camera::eye();

Mesh probed_brick()
{
    return test::mesh_of(core::shapes::box({2, 2, 2}, {1, 1, 1}));
}

TEST(BladeProbe, HitsWhatTheStrokeCrosses)
{
    const auto body = test::body_of(probed_brick(), 1, {0, 0, 0});
    EXPECT_TRUE(blade_hits(kEye, {-3, 0}, {3, 0}, *body));
    EXPECT_TRUE(blade_hits(kEye, {-3, 0.5}, {0, 0.5}, *body)) << "ends inside";
    EXPECT_TRUE(blade_hits(kEye, {0, 0.5}, {3, 0.5}, *body)) << "starts inside";
    EXPECT_TRUE(blade_hits(kEye, {0.1, 0.5}, {0.3, 0.4}, *body)) << "lies inside";
    EXPECT_FALSE(blade_hits(kEye, {-3, 2}, {3, 2}, *body)) << "passes above";
    EXPECT_FALSE(blade_hits(kEye, {-3, 0}, {-2, 0}, *body)) << "ends before it";
    EXPECT_FALSE(blade_hits(kEye, {2, 0}, {3, 0}, *body)) << "begins behind it";
    EXPECT_FALSE(blade_hits(kEye, {0, 0}, {0, 0}, *body)) << "a point is no stroke";
}

TEST(BladeProbe, JudgesDepthAsThePlayerSeesIt)
{
    // Half way to the eye a brick at x = 1 looks as if it were at x = 2.
    const auto body = test::body_of(test::mesh_of(core::shapes::box({0.5f, 0.5f, 0.5f}, {1, 1, 1})), 1, {1, 0, 5});
    EXPECT_TRUE(blade_hits(kEye, {2, -1}, {2, 1}, *body));
    EXPECT_FALSE(blade_hits(kEye, {1, -1}, {1, 1}, *body));
}

TEST(BladeProbe, ABallIsHitOnItsWholeRadius)
{
    const auto body = test::body_of(test::shape("uv_sphere"), 1, {0, 0, 0}, {}, ProxyKind::sphere);
    const double r = 0.97 * body->proxy().proxy().radius;
    EXPECT_TRUE(blade_hits(kEye, {-3, r}, {3, r}, *body));
    EXPECT_FALSE(blade_hits(kEye, {-3, 1.1 * r}, {3, 1.1 * r}, *body));
}

// The referee: points of the proxy's surface and of the swept segment, by brute force over corners of a cube.
RC_GTEST_PROP(BladeProbe, AgreesWithAProjectionOfTheBrick, ())
{
    core::Random random(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    const auto between = [&](double lo, double hi) { return lo + (hi - lo) * random.unit(); };
    const glm::dvec3 centre(between(-3, 3), between(-2, 2), between(-2, 2));
    const auto body = test::body_of(probed_brick(), 1, centre);
    const glm::dvec2 from(between(-6, 6), between(-4, 4)), to(between(-6, 6), between(-4, 4));

    // Seen from the eye a brick is the convex hull of its corners on the stage: the stroke crosses it when some corner
    // is on each side of every separating line. Candidates for one: the stroke's normal, and all edges between corners.
    std::vector<glm::dvec2> outline;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 p = centre + glm::dvec3((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
        const double t = kEye.z / (kEye.z - p.z);
        outline.push_back(t * glm::dvec2(p));
    }
    double gap = -1e300;  // largest separation along any candidate axis
    const auto separate = [&](const glm::dvec2& edge) {
        if (glm::length(edge) < 1e-9) return;
        const glm::dvec2 axis = glm::normalize(glm::dvec2(-edge.y, edge.x));
        double low = 1e300, high = -1e300;
        for (const glm::dvec2& p : outline) {
            low = std::min(low, glm::dot(axis, p));
            high = std::max(high, glm::dot(axis, p));
        }
        const double a = glm::dot(axis, from), b = glm::dot(axis, to);
        gap = std::max({gap, std::min(a, b) - high, low - std::max(a, b)});
    };
    separate(to - from);
    for (const glm::dvec2& p : outline)
        for (const glm::dvec2& q : outline) separate(q - p);
    RC_PRE(std::abs(gap) > 1e-3);  // grazing is a matter of rounding
    RC_ASSERT(blade_hits(kEye, from, to, *body) == (gap < 0.0));
}

}  // namespace
}  // namespace kerf::sim
