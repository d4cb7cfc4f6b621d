#pragma once

#include <cstdint>
#include <vector>

#include "common/caps/cap_triangulator.h"
#include "common/caps/loop_boxes.h"
#include "common/caps/touching_loops.h"

namespace kerf::core {

/// Closed rings of corners, one behind the other.
struct Rings
{
    /// Of the outline; a point is there once for each bridge that ends at it, and once more.
    std::vector<Index> points;
    std::vector<CapLink> links;  ///< the edge that leaves each: of the outline, or bridge_link()
    std::vector<Index> starts;   ///< first corner of each ring, and their number at the end
    std::size_t bridge_count = 0;
    std::vector<Index> shared;  ///< points as in CapMesh::shared_points, where loops touch
};

/// One of the two edges of a bridge, which are to be joined once both have a triangle. Numbered behind the outline's.
inline CapLink bridge_link(const CapOutline& outline, std::size_t bridge, std::size_t side)
{
    return CapLink::to_outline(static_cast<Index>(outline.points.size() + 2 * bridge + side));
}

/// Makes one ring of each outer loop and its holes. Loops that touch in points are parted or joined there. From the
/// leftmost point of each hole a bridge leads to a point on the left that it sees, forth and back (Eberly, "Triangulation
/// by Ear Clipping", section 5). Keeps its memory.
class HoleBridger
{
public:
    /// False if a hole has nothing on its left, or after `most_looks`, which is counted down. O(k log k) for few holes
    /// side by side.
    bool build(const CapOutline& outline, Rings& rings, std::uint64_t& most_looks);

    /// Joins the triangles on both sides of each bridge, once all rings are divided into triangles. O(triangles).
    void join_triangles(const CapOutline& outline, const Rings& rings, CapMesh& cap);

private:
    void begin(const CapOutline& outline);
    bool bridge_all(Rings& rings);
    void measure_rows();
    double twice_area(Index loop) const;
    Index leftmost(Index loop) const;
    Index seen_from(Index hole);
    bool find_edge_on_the_left(const glm::dvec2& p, double row_end, double& hit, Index& edge);
    Index nearest_between(Index hole, const glm::dvec2& hit, Index end);
    Index copy_towards(Index point, Index hole) const;
    void add_bridge(std::size_t bridge, Index corner, Index hole);
    Index copy(Index corner);
    void join(Index from, Index to, CapLink link);
    void collect(Rings& rings);
    const glm::dvec2& at(Index corner) const { return outline_->points[point_[corner]]; }
    bool is_left_of(Index a, Index b) const;

    const CapOutline* outline_ = nullptr;
    std::uint64_t looks_left_ = 0;
    LoopParter parter_;
    std::vector<Index> holes_;                               ///< the leftmost point of each
    std::vector<std::uint8_t> is_joined_;                    ///< by loop: outer ones, and holes that a bridge leads to
    std::vector<Index> loop_of_, successor_, starts_;        ///< of the outline's points; a point of each loop
    std::vector<Index> point_, before_, after_, next_copy_;  ///< of corners: the points, then what bridges add
    std::vector<CapLink> link_;
    std::vector<std::uint8_t> is_taken_;  ///< corners that are on a ring
    std::vector<CapLink> sides_;          ///< triangles on both sides of each bridge
    LoopBoxes edges_;
    double left_end_ = 0.0, first_row_ = 0.0;
};

}  // namespace kerf::core
