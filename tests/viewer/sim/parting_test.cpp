#include "viewer/sim/parting.h"

#include <gtest/gtest.h>
// (RapidCheck's GoogleTest support needs gtest.h first.)
#include <rapidcheck/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "common/support/random.h"

namespace kerf::sim {
namespace {

// Pieces of a body with its plane: any number on each side, anywhere, of any mass.
struct Scatter
{
    glm::dvec3 centre{0.0}, normal{0.0, 1.0, 0.0}, on_plane{0.0};
    Motion motion;
    std::vector<Part> parts;
    double mass = 0.0;

    glm::dvec3 momentum() const
    {
        glm::dvec3 sum(0.0);
        for (const Part& p : parts) sum += p.mass * p.motion.velocity;
        return sum;
    }
    glm::dvec3 angular_momentum() const
    {
        glm::dvec3 sum(0.0);
        for (const Part& p : parts)
            sum += p.inertia * p.motion.spin + glm::cross(p.centre - centre, p.mass * p.motion.velocity);
        return sum;
    }
    // Of the body before: one rigid body.
    glm::dvec3 angular_momentum_before() const
    {
        glm::dvec3 sum(0.0);
        for (const Part& p : parts) {
            const glm::dvec3 r = p.centre - centre;
            sum += p.inertia * motion.spin + p.mass * glm::cross(r, motion.velocity + glm::cross(motion.spin, r));
        }
        return sum;
    }
};

Scatter scatter(std::uint64_t seed)
{
    core::Random random(seed);
    const auto vector = [&](double size) {
        return size * glm::dvec3(2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1);
    };
    Scatter s;
    s.normal = glm::normalize(vector(1.0) + glm::dvec3(0, 0, 1e-3));
    s.motion = {vector(10.0), vector(5.0)};
    const std::uint32_t pieces = 2 + random.below(5);
    for (std::uint32_t i = 0; i < pieces; ++i) {
        Part p;
        p.positive = i == 0 || (i > 1 && random.below(2) == 0);
        p.mass = std::pow(10.0, 4 * random.unit() - 2);
        p.centre = vector(1.0);
        const double height = 0.05 + random.unit();
        p.centre += ((p.positive ? height : -height) - glm::dot(p.centre, s.normal)) * s.normal;
        // Two rods across each other: any tensor of that kind is one of a solid.
        const glm::dvec3 a = vector(0.3), b = vector(0.3), c = vector(0.3);
        for (const glm::dvec3& d : {a, b, c})
            p.inertia += p.mass * (glm::dmat3(glm::dot(d, d) + 1e-4) - glm::outerProduct(d, d));
        s.mass += p.mass;
        s.centre += p.mass * p.centre;
        s.parts.push_back(p);
    }
    s.centre /= s.mass;
    return s;
}

RC_GTEST_PROP(Parting, KeepsLinearAndAngularMomentum, ())
{
    Scatter s = scatter(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    part_ways(s.centre, s.motion, s.normal, s.on_plane, s.parts);
    const glm::dvec3 before = s.mass * s.motion.velocity;
    RC_ASSERT(glm::distance(s.momentum(), before) <= 1e-12 * s.mass * 20.0);
    RC_ASSERT(glm::distance(s.angular_momentum(), s.angular_momentum_before()) <= 1e-11 * s.mass * 40.0);
}

RC_GTEST_PROP(Parting, WithoutAKickEveryPieceGoesOnAsPartOfTheRigidBody, ())
{
    Scatter s = scatter(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    part_ways(s.centre, s.motion, s.normal, s.on_plane, s.parts, 0.0);
    for (const Part& p : s.parts) {
        const glm::dvec3 expected = s.motion.velocity + glm::cross(s.motion.spin, p.centre - s.centre);
        RC_ASSERT(glm::distance(p.motion.velocity, expected) <= 1e-12 * 100.0);
        RC_ASSERT(glm::distance(p.motion.spin, s.motion.spin) == 0.0);
    }
}

RC_GTEST_PROP(Parting, PushesTheSidesApartAndNeverSpinsThemWildly, ())
{
    Scatter s = scatter(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    std::vector<Part> still = s.parts;
    part_ways(s.centre, s.motion, s.normal, s.on_plane, still, 0.0);
    part_ways(s.centre, s.motion, s.normal, s.on_plane, s.parts);
    glm::dvec3 up(0.0), down(0.0);
    double above = 0.0, below = 0.0;
    for (std::size_t i = 0; i < still.size(); ++i) {
        const Part& p = s.parts[i];
        const glm::dvec3 kick = p.mass * (p.motion.velocity - still[i].motion.velocity);
        (p.positive ? up : down) += kick;
        (p.positive ? above : below) += p.mass;
        RC_ASSERT(glm::length(p.motion.spin - s.motion.spin) <= kFastestKickSpin * (1 + 1e-9));
    }
    // Equal and opposite, along the normal, and no faster than was asked for.
    const double impulse = glm::dot(up, s.normal);
    RC_ASSERT(impulse > 0.0);
    RC_ASSERT(glm::length(up + down) <= 1e-9 * s.mass);
    RC_ASSERT(glm::length(up - impulse * s.normal) <= 1e-9 * s.mass);
    RC_ASSERT(impulse / above + impulse / below <= kPartingSpeed * (1 + 1e-9));
}

TEST(Parting, TwoEqualHalvesLeaveEachOtherAtThePartingSpeed)
{
    std::vector<Part> halves(2);
    for (Part& half : halves) {
        half.mass = 3.0;
        half.inertia = glm::dmat3(1.0);
    }
    halves[0].positive = true;
    halves[0].centre = {0, 0.5, 0};
    halves[1].centre = {0, -0.5, 0};
    part_ways({0, 0, 0}, {}, {0, 1, 0}, {0, 0, 0}, halves);
    EXPECT_NEAR(halves[0].motion.velocity.y - halves[1].motion.velocity.y, kPartingSpeed, 1e-12);
    EXPECT_EQ(halves[0].motion.spin, glm::dvec3(0.0));
}

TEST(Parting, ASideWithoutMassOrInertiaGivesNumbers)
{
    std::vector<Part> parts(2);
    parts[0].positive = true;
    parts[0].mass = 1.0;
    parts[0].centre = {0, 1, 0};
    parts[1].mass = 1e-30;
    parts[1].centre = {1, -1, 0};
    part_ways({0, 1, 0}, {{1, 2, 3}, {4, 5, 6}}, {0, 1, 0}, {0, 0, 0}, parts);
    for (const Part& part : parts) EXPECT_TRUE(std::isfinite(glm::length(part.motion.velocity + part.motion.spin)));
}

}  // namespace
}  // namespace kerf::sim
