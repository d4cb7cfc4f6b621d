#include "viewer/sim/breaking/scatter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "common/support/random.h"

namespace kerf::sim {
namespace {

std::vector<ScatteredPart> parts_of(std::uint64_t seed, std::size_t count)
{
    core::Random random(seed);
    const auto vector = [&] { return glm::dvec3(random.unit(), random.unit(), random.unit()) - 0.5; };
    std::vector<ScatteredPart> parts;
    for (std::size_t i = 0; i < count; ++i) parts.push_back({0.1 + random.unit(), vector(), {vector(), vector()}});
    return parts;
}

glm::dvec3 momentum_of(const std::vector<ScatteredPart>& parts)
{
    glm::dvec3 sum(0.0);
    for (const ScatteredPart& part : parts) sum += part.mass * part.motion.velocity;
    return sum;
}

glm::dvec3 angular_momentum_of(const std::vector<ScatteredPart>& parts)
{
    glm::dvec3 sum(0.0);
    for (const ScatteredPart& part : parts) sum += glm::cross(part.centre, part.mass * part.motion.velocity);
    return sum;
}

}  // namespace

RC_GTEST_PROP(Scatter, ChangesNeitherMomentumNorAngularMomentum, ())
{
    const std::vector<ScatteredPart> before =
        parts_of(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<std::size_t>(1, 100));
    std::vector<ScatteredPart> after = before;
    scatter(after, 3.0);
    RC_ASSERT(glm::distance(momentum_of(before), momentum_of(after)) < 1e-12 * double(before.size()));
    RC_ASSERT(glm::distance(angular_momentum_of(before), angular_momentum_of(after)) < 1e-12 * double(before.size()));
}

RC_GTEST_PROP(Scatter, NoTwoComeNearerAndTheOutermostHasTheSpeed, ())
{
    std::vector<ScatteredPart> parts =
        parts_of(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<std::size_t>(2, 60));
    for (ScatteredPart& part : parts) part.motion = {};
    scatter(parts, 3.0);
    double fastest = 0.0;
    for (const ScatteredPart& a : parts) {
        fastest = std::max(fastest, glm::length(a.motion.velocity));
        for (const ScatteredPart& b : parts)
            RC_ASSERT(glm::dot(b.centre - a.centre, b.motion.velocity - a.motion.velocity) >= -1e-12);
    }
    RC_ASSERT(std::abs(fastest - 3.0) < 1e-9);
}

TEST(Scatter, LeavesASinglePartAsItWas)
{
    std::vector<ScatteredPart> one{{2.0, {1, 2, 3}, {{4, 5, 6}, {7, 8, 9}}}};
    scatter(one, 3.0);
    EXPECT_EQ(one[0].motion.velocity, glm::dvec3(4, 5, 6));
    EXPECT_EQ(one[0].motion.spin, glm::dvec3(7, 8, 9));
}

}  // namespace kerf::sim
