#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/caps/outline_loops.h"
#include "common/geometry/disjoint_sets.h"
#include "common/geometry/ray_crossing.h"
#include "common/mesh/box.h"
#include "common/mesh/plane.h"

// How a hole of a section finds its outer loop. common/cutting/group_pieces.cpp sorts the loops by solid first.

namespace kerf::core {

/// The section as edges between points, without edges that run forth and back.
class SectionOutline
{
public:
    SectionOutline(const Plane& plane, std::span<const glm::vec3> points, std::span<const OutlineEdge> edges)
        : plane_(plane), points_(points)
    {
        std::vector<bool> is_gone(edges.size(), false);
        for (const auto& pair : opposite_edges(points.size(), edges)) is_gone[pair[0]] = is_gone[pair[1]] = true;
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (!is_gone[e] && edges[e].from != edges[e].to) edges_.push_back(edges[e]);
    }

    const Plane& plane() const { return plane_; }
    std::span<const glm::vec3> points() const { return points_; }
    std::span<const OutlineEdge> edges() const { return edges_; }
    const glm::vec3& position(std::uint32_t point) const { return points_[point]; }

private:
    const Plane& plane_;
    std::span<const glm::vec3> points_;
    std::vector<OutlineEdge> edges_;
};

/// A section loop in the plane of the two other axes.
struct FlatLoop
{
    std::uint32_t part = 0;
    double area2 = 0.0;  ///< twice the area, positive for an outer loop
    Box box;             ///< z = 0
    std::vector<PlanarPoint> points;
};

/// Projects a loop of the outline, which bounds `part`, along `axis`. Neither its size nor its points depend on where
/// the path begins.
FlatLoop flatten(const SectionOutline& outline, std::span<const std::uint32_t> path, std::uint32_t part, int axis);

/// Joins each hole of one solid with the smallest outer loop around it, and with all others around it that are as
/// small: they cannot be told apart, and back ends may order them differently. A hole lies in an outer loop if at least
/// two of three interior sample points do. O(e log e) for e edges.
void join_holes(std::span<const FlatLoop> loops, DisjointSets& pieces);

}  // namespace kerf::core
