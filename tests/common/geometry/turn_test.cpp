// The sign of a turn is that of the exact sum, however far the coordinates' exponents lie apart: held against CGAL's
// exact predicates.

#include "common/geometry/turn.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace kerf::core {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triple = std::array<glm::dvec2, 3>;

int sign_of(double value)
{
    return (value > 0.0) - (value < 0.0);
}

int turn_of_cgal(const Triple& t)
{
    const auto point = [&](std::size_t i) { return Kernel::Point_2(t[i].x, t[i].y); };
    return Kernel().orientation_2_object()(point(0), point(1), point(2));
}

/// Triples on which rounding may go wrong.
class Triples
{
public:
    static constexpr std::size_t kKinds = 6;

    Triple next(std::size_t kind)
    {
        Triple t;
        for (glm::dvec2& p : t) p = {coordinate(kind), coordinate(kind)};
        switch (below(8)) {
            case 0:
                t[below(3)] = t[below(3)];
                break;
            case 1:
                t[below(3)].x = t[below(3)].x;
                break;
            case 2:
                t[below(3)].y = t[below(3)].y;
                break;
            case 3:
            case 4:
            case 5:
                make_nearly_collinear(t);
                break;
            default:
                break;
        }
        return t;
    }

private:
    std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(bits_() % bound); }

    float any_float()
    {
        for (;;)
            if (const float value = std::bit_cast<float>(static_cast<std::uint32_t>(bits_())); std::isfinite(value))
                return value;
    }

    double coordinate(std::size_t kind)
    {
        const double sign = below(2) == 0 ? 1.0 : -1.0;
        switch (kind) {
            case 0:
                return any_float();
            // Few bits, exponents far apart.
            case 1:
                return sign * std::ldexp(1.0 + below(8), static_cast<int>(below(270)) - 149);
            case 2: {
                static constexpr std::array kHard{0.0f,
                                                  1.0f,
                                                  1e-20f,
                                                  1.62488128e-20f,
                                                  1e-39f,
                                                  3e38f,
                                                  std::numeric_limits<float>::denorm_min(),
                                                  std::numeric_limits<float>::min(),
                                                  std::numeric_limits<float>::max(),
                                                  std::numeric_limits<float>::epsilon()};
                return sign * double(kHard[below(kHard.size())]);
            }
            // A grid, and some units in the last place beside it.
            case 3:
                return sign * (below(8) + std::ldexp(below(4), -24));
            // One size.
            case 4:
                return sign * double(float(std::ldexp(double(below(1u << 24)), -24)));
            // Points set apart by less than a float can tell: untangling_triangulator.cpp.
            default:
                return any_float() * 0x1p-64 + below(8) * 0x1p-48;
        }
    }

    /// Moves the last point to the line of the others, or to one of its neighbours.
    void make_nearly_collinear(Triple& t)
    {
        const double share = std::ldexp(double(below(1u << 12)), -11) - 0.5;
        t[2] = t[0] + share * (t[1] - t[0]);
        for (int axis = 0; axis < 2; ++axis) {
            float value = static_cast<float>(t[2][axis]);
            for (std::uint32_t i = below(3); i > 0; --i) value = std::nextafter(value, below(2) == 0 ? -3e38f : 3e38f);
            if (std::isfinite(value)) t[2][axis] = value;
        }
        std::swap(t[2], t[below(3)]);
    }

    std::mt19937_64 bits_{20260101};
};

TEST(Turn, HasTheSignOfCgalsExactPredicate)
{
    constexpr std::size_t kTriples = 10'000'000;
    Triples triples;
    std::size_t rounded_wrong = 0, collinear = 0;
    for (std::size_t i = 0; i < kTriples; ++i) {
        const Triple t = triples.next(i % Triples::kKinds);
        const auto& [a, b, c] = t;
        const int expected = turn_of_cgal(t);
        ASSERT_EQ(sign_of(turn(a, b, c)), expected)
            << std::hexfloat << a.x << ", " << a.y << "; " << b.x << ", " << b.y << "; " << c.x << ", " << c.y;
        rounded_wrong += sign_of((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)) != expected;
        collinear += expected == 0;
    }
    // The triples are hard ones.
    EXPECT_GT(rounded_wrong, kTriples / 100);
    EXPECT_GT(collinear, kTriples / 100);
}

TEST(Turn, IsTheAreaWhereRoundingDoesNotMatter)
{
    EXPECT_EQ(turn({0, 0}, {1, 0}, {0, 1}), 1.0);
    EXPECT_EQ(turn({0, 0}, {0, 1}, {1, 0}), -1.0);
    EXPECT_EQ(turn({1, 1}, {2, 2}, {4, 4}), 0.0);
}

TEST(Turn, SeesWhatIsTooSmallToChangeADifference)
{
    // 0.0013 - 1.6e-20 is 0.0013 in double: a touch that a section had.
    const glm::dvec2 a(0.125f, 0), b(0.1348581165f, 1.62488128e-20f), c(0.1348581165f, 0),
        d(0.1330788136f, 0.00131935824f);
    EXPECT_GT(turn(a, b, d), 0.0);
    EXPECT_LT(turn(a, b, c), 0.0);
    EXPECT_LT(turn(c, d, b), 0.0);
    EXPECT_GT(turn(c, d, a), 0.0);
    // The size is right, too.
    EXPECT_DOUBLE_EQ(turn({0, 0}, {1, 1e-20}, {2, 3e-20}), 1e-20);
}

}  // namespace
}  // namespace kerf::core
