#include "viewer/effects/shake.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace kerf::test {

using effects::Shake;

TEST(Shake, TremblesAndComesToRestWhereItWas)
{
    Shake shake;
    EXPECT_TRUE(shake.at_rest());
    EXPECT_EQ(shake.offset(), glm::vec2(0.0f));
    shake.hit(1.0f);
    float farthest = 0.0f;
    int steps = 0;
    for (; !shake.at_rest(); ++steps) {
        ASSERT_LT(steps, 200) << "it must end";
        shake.advance(1.0f / 120.0f);
        farthest = std::max({farthest, std::abs(shake.offset().x), std::abs(shake.offset().y)});
    }
    EXPECT_GT(farthest, 0.02f);
    EXPECT_LE(farthest, Shake::kFarthest);
    EXPECT_EQ(shake.offset(), glm::vec2(0.0f));
}

TEST(Shake, ManyHitsAreNoStrongerThanTheStrongest)
{
    Shake shake;
    for (int i = 0; i < 100; ++i) shake.hit(1.0f);
    for (int i = 0; i < 50; ++i) {
        shake.advance(0.004f);
        EXPECT_LE(std::abs(shake.offset().x), Shake::kFarthest);
        EXPECT_LE(std::abs(shake.offset().y), Shake::kFarthest);
    }
}

}  // namespace kerf::test
