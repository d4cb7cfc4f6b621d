#pragma once

#include <array>

namespace kerf::core {

/// A line across a triangle: where two functions are equal that are linear in it, given by their values at its corners.
/// The side on which `above` is larger counts as positive.
struct BorderLine
{
    std::array<double, 3> above{}, below{};

    double difference(int corner) const { return above[corner] - below[corner]; }
    /// The side of the triangle from a corner to the next one. The triangle lies on its positive side.
    static BorderLine side(int corner)
    {
        BorderLine line;
        line.above[(corner + 2) % 3] = 1.0;
        return line;
    }
};

/// The side of `line` that the point lies on in which two lines meet: 1, -1, or 0 if it lies on the line. Exact. (The
/// point, in barycentric coordinates, is the cross product of the lines' differences. A floating-point filter decides
/// nearly all cases; the others are summed up without rounding, see expansion.h.)
int side_of_crossing(const BorderLine& one, const BorderLine& other, const BorderLine& line);

}  // namespace kerf::core
