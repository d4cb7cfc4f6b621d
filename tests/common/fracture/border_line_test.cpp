#include "common/fracture/border_line.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace kerf::core {
namespace {

/// Whole numbers, of which a filter tells nothing if they are few.
BorderLine random_line(test::Random& random, std::uint32_t most)
{
    BorderLine line;
    for (int i = 0; i < 3; ++i) {
        line.above[i] = double(random.below(most));
        line.below[i] = double(random.below(most));
    }
    return line;
}

__extension__ using Wide = __int128;

/// The same in whole numbers.
int side_in_whole_numbers(const BorderLine& one, const BorderLine& other, const BorderLine& line)
{
    const auto at = [](const BorderLine& l, int i) { return Wide(l.above[i]) - Wide(l.below[i]); };
    Wide weight = 0, height = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const Wide part = at(one, j) * at(other, k) - at(one, k) * at(other, j);
        weight += part;
        height += part * at(line, i);
    }
    const auto sign = [](Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
    return sign(weight) * sign(height);
}

TEST(BorderLine, SidesAreExact)
{
    test::Random random(11);
    int zeros = 0;
    for (const std::uint32_t most : {2u, 3u, 5u, 1000u, 1u << 20, 1u << 30})
        for (int i = 0; i < 20'000; ++i) {
            const BorderLine one = random_line(random, most), other = random_line(random, most);
            const BorderLine line = random_line(random, most);
            const int expected = side_in_whole_numbers(one, other, line);
            zeros += expected == 0;
            ASSERT_EQ(side_of_crossing(one, other, line), expected);
        }
    EXPECT_GT(zeros, 1000);
}

TEST(BorderLine, NearlyEqualLinesAreToldApart)
{
    // In doubles the difference is lost: tiny - 1 is -1.
    const double tiny = 0x1p-60;
    const BorderLine one{{1.0, tiny, 0.0}, {0.0, 1.0, 1.0}}, other{{1.0, 0.0, 0.0}, {0.0, 1.0, 1.0}};
    BorderLine line;
    line.above = {1.0, 0.0, 0.0};
    line.below = {0.0, 1.0, 1.0};
    EXPECT_NE(side_of_crossing(one, BorderLine::side(0), line), 0);
    EXPECT_EQ(side_of_crossing(other, BorderLine::side(2), line), 0);
}

}  // namespace
}  // namespace kerf::core
