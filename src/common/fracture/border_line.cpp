#include "common/fracture/border_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "common/geometry/expansion.h"

namespace kerf::core {

namespace {

/// A difference of doubles has an error of one unit, 2^-53 of it. So a product of two has three, and each of the three parts
/// of the weight, twice the largest product at most, eight of the largest product; with two more for each sum that makes
/// 36 at most. Of the height, with a third difference, 48. Rounded up.
constexpr double kUnit = 0x1p-53, kUnitsOfWeight = 48.0, kUnitsOfHeight = 64.0;

double largest(const BorderLine& line)
{
    return std::max({std::abs(line.difference(0)), std::abs(line.difference(1)), std::abs(line.difference(2))});
}

int sign_of(double value)
{
    return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

/// Adds sign * (a.above - a.below) * (b.above - b.below) at one corner each.
template <std::size_t kMost>
void add_two(Expansion<kMost>& sum, double sign, const BorderLine& a, int at_a, const BorderLine& b, int at_b)
{
    sum.add_product(sign * a.above[at_a], b.above[at_b]);
    sum.add_product(-sign * a.above[at_a], b.below[at_b]);
    sum.add_product(-sign * a.below[at_a], b.above[at_b]);
    sum.add_product(sign * a.below[at_a], b.below[at_b]);
}

template <std::size_t kMost>
void add_three(Expansion<kMost>& sum, double sign, const BorderLine& a, int at_a, const BorderLine& b, int at_b,
               const BorderLine& c, int at_c)
{
    for (const auto& [factor, of_a] : {std::pair{sign, a.above[at_a]}, {-sign, a.below[at_a]}})
        for (const auto& [again, of_b] : {std::pair{factor, b.above[at_b]}, {-factor, b.below[at_b]}}) {
            sum.add_product(again * of_a, of_b, c.above[at_c]);
            sum.add_product(-again * of_a, of_b, c.below[at_c]);
        }
}

int exact_side(const BorderLine& one, const BorderLine& other, const BorderLine& line)
{
    Expansion<48> weight;
    Expansion<192> height;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        add_two(weight, 1.0, one, j, other, k);
        add_two(weight, -1.0, one, k, other, j);
        add_three(height, 1.0, one, j, other, k, line, i);
        add_three(height, -1.0, one, k, other, j, line, i);
    }
    return sign_of(weight.rounded()) * sign_of(height.rounded());
}

}  // namespace

int side_of_crossing(const BorderLine& one, const BorderLine& other, const BorderLine& line)
{
    double weight = 0.0, height = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double part = one.difference(j) * other.difference(k) - one.difference(k) * other.difference(j);
        weight += part;
        height += part * line.difference(i);
    }
    const double of_two = largest(one) * largest(other);
    if (std::abs(weight) > kUnitsOfWeight * kUnit * of_two &&
        std::abs(height) > kUnitsOfHeight * kUnit * of_two * largest(line))
        return (weight > 0.0) == (height > 0.0) ? 1 : -1;
    return exact_side(one, other, line);
}

}  // namespace kerf::core
