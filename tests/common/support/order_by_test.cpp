#include "common/support/order_by.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "common/support/random.h"

namespace kerf::core {
namespace {

TEST(OrderBy, KeepsNumbersOfEqualKeysInTheirOrder)
{
    Random random(3);
    for (std::uint32_t count = 0; count < 200; ++count) {
        std::vector<std::uint64_t> keys(count);
        for (std::uint64_t& key : keys) key = random.below(1 + count / 4);
        std::vector<std::uint32_t> order{7, 7, 7}, expected(count);
        order_by(order, count, [&](std::uint32_t i) { return keys[i]; });
        std::iota(expected.begin(), expected.end(), 0u);
        std::stable_sort(expected.begin(), expected.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
        EXPECT_EQ(order, expected);
    }
}

}  // namespace
}  // namespace kerf::core
