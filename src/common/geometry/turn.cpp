#include "common/geometry/turn.h"

#include <cmath>

#include "common/geometry/expansion.h"

namespace kerf::core {

namespace {

/// Whether the rounded difference a - b is exact.
bool is_exact_difference(double a, double b)
{
    // The tail of TWO-DIFF, section 2.
    const double difference = a - b, part_of_b = a - difference;
    return (a - (difference + part_of_b)) + (part_of_b - b) == 0.0;
}

}  // namespace

double turn_by_expansion(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    Expansion<12> area;
    if (is_exact_difference(b.x, a.x) && is_exact_difference(c.y, b.y) && is_exact_difference(b.y, a.y) &&
        is_exact_difference(c.x, b.x)) {
        area.add_product(b.x - a.x, c.y - b.y);
        area.add_product(a.y - b.y, c.x - b.x);
        return area.rounded();
    }
    // The same area, multiplied out; b.x * b.y is in both products and cancels.
    area.add_product(b.x, c.y);
    area.add_product(-c.x, b.y);
    area.add_product(c.x, a.y);
    area.add_product(-a.x, c.y);
    area.add_product(a.x, b.y);
    area.add_product(-b.x, a.y);
    return area.rounded();
}

}  // namespace kerf::core
