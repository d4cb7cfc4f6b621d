#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/tolerances.h"

namespace kerf::core {

/// The distance between neighbouring floats at the largest coordinate, in mesh units: how coarse positions are.
double coordinate_grain(const Box& box);

/// The shortest edge of triangles that are shown one after another, in mesh units; those of length 0 don't count.
class ShortestEdge
{
public:
    /// The corners of a triangle.
    void add(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r)
    {
        for (const glm::dvec3& edge : {q - p, r - q, p - r}) {
            // A shorter edge is rare: a branch that is predicted costs less than a minimum that waits for the one before.
            const double square = edge.x * edge.x + edge.y * edge.y + edge.z * edge.z;
            if (square < square_ && square > 0.0) square_ = square;
        }
    }

    /// Infinite if there is none.
    double length() const { return std::sqrt(square_); }

private:
    double square_ = std::numeric_limits<double>::infinity();
};

/// Length of the shortest edge, in mesh units; infinite if there is none. Edges between equal positions and triangles
/// with an index out of range do not count. O(n).
double shortest_edge(std::span<const Vertex> vertices, std::span<const Triangle> triangles);

/// True if the shortest edge is below kCoarseUnits times the grain, as in a small mesh far from the origin. Such a mesh
/// is still cut closed and without a crash; if you can, move it to the origin before it is rounded to float.
inline bool has_coarse_coordinates(double shortest_edge, const Box& box)
{
    return shortest_edge < kCoarseUnits * coordinate_grain(box);
}

}  // namespace kerf::core
