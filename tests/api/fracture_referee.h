#pragma once

#include <kerf/fracture.h>

#include <array>
#include <vector>

// A fracture judged by its pieces' triangles alone: code that shares nothing with what made them.

namespace kerf::test {

using Place = std::array<float, 3>;
/// The corners of a triangle, from the first one in space on.
using Corners = std::array<Place, 3>;

/// What a piece consists of.
struct Triangles
{
    std::vector<Corners> surface, caps;
    bool closed = false;  ///< each directed edge, by places, is there as often as its reverse
    double volume = 0.0;

    explicit Triangles(const Object& object);
};

/// Pieces are closed, and fill a solid.
void expect_full(const Object& whole, Fracture& fracture);

/// What must hold of any fracture of a solid without caps: it is filled, each cap faces one of another piece, the same turned
/// over, and bonds have their areas.
void expect_right(const Object& whole, Fracture& fracture);

}  // namespace kerf::test
