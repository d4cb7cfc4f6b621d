#include "common/geometry/turn.h"

#include <array>
#include <cstddef>

namespace kerf::core {

namespace {

/// A sum of doubles without rounding: doubles whose bits don't overlap, ascending in size, with zeros among them. Its
/// sign is that of the last one that is not 0. Shewchuk 1997, section 2.
class Expansion
{
public:
    /// GROW-EXPANSION (figure 6).
    void add(double value)
    {
        for (std::size_t i = 0; i < count_; ++i) {
            // TWO-SUM (figure 4).
            const double sum = value + parts_[i], part_of_sum = sum - value;
            parts_[i] = (value - (sum - part_of_sum)) + (parts_[i] - part_of_sum);
            value = sum;
        }
        parts_[count_++] = value;
    }

    /// The rounded product and its rounding error.
    void add_product(double a, double b)
    {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    double rounded() const
    {
        for (std::size_t i = count_; i > 0; --i)
            if (parts_[i - 1] != 0.0) return parts_[i - 1];
        return 0.0;
    }

private:
    std::array<double, 12> parts_;
    std::size_t count_ = 0;
};

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
    Expansion area;
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
