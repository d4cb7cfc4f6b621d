#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace kerf::core {

/// A sum of doubles without rounding: doubles whose bits don't overlap, ascending in size, with zeros among them. Its
/// sign is that of the last one that is not 0. Shewchuk 1997, section 2.
///
/// @tparam kMost  how many doubles are added; a product of two counts as two, one of three as four
template <std::size_t kMost>
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
    void add_product(double a, double b, double c)
    {
        const double product = a * b;
        add_product(std::fma(a, b, -product), c);
        add_product(product, c);
    }

    double rounded() const
    {
        for (std::size_t i = count_; i > 0; --i)
            if (parts_[i - 1] != 0.0) return parts_[i - 1];
        return 0.0;
    }

private:
    std::array<double, kMost> parts_;
    std::size_t count_ = 0;
};

}  // namespace kerf::core
