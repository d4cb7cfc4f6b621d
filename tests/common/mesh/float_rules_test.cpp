#include "common/mesh/float_rules.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>

namespace kerf::core {
namespace {

/// Hides a value from the optimiser.
double opaque(double value)
{
    volatile double hidden = value;
    return hidden;
}

// GCC 12 took the pair for the rounded pair, from -O2, if it put pairs into one register (-ftree-slp-vectorize).
TEST(FloatRules, PairsThatAreRoundedToFloatStayRounded)
{
    const glm::dvec2 exact{opaque(0.1), opaque(0.2)};
    const glm::dvec2 rounded{glm::vec2(exact)};
    EXPECT_EQ(rounded.x, 0.100000001490116119384765625);
    EXPECT_EQ(rounded.y, 0.20000000298023223876953125);
    const glm::dvec4 four{exact, exact};
    EXPECT_EQ(glm::dvec4(glm::vec4(four)), glm::dvec4(rounded, rounded));
}

// A fused multiply-add would give what rounding took away.
TEST(FloatRules, ProductsAreRoundedBeforeTheyAreAdded)
{
    const double a = opaque(1 + 0x1p-30), square = opaque(1 + 0x1p-29);
    EXPECT_EQ(a * a - square, 0.0);
}

}  // namespace
}  // namespace kerf::core
