#include "halfedge/cut/cap_planner.h"

namespace kerf::core::halfedge {

void CapPlanner::plan(const Plane& plane, CapQuality quality, const Found& found, Section& section, Caps& caps)
{
    loops_.clear();
    for (const Loop& loop : section.loops)
        if (loop.closed) loops_.push_back({loop.first, loop.count, loop.cap_set});
    closer_.close(plane, loops_, quality, section.loop_points, caps);

    for (const Index edge : caps.crossing_edges) {
        section.loop_edges.push_back(section.loop_edges[edge]);
        section.share_point(found, section.loop_edges.size() - 1);
    }
    for (const auto& [a, b] : caps.cancelled) {
        section.cancelled.push_back({section.loop_edges[a], section.loop_edges[b]});
        for (const OutlineEdgeId edge : section.cancelled.back()) section.share_ends(found, edge);
    }
    for (const Index point : caps.shared_points) section.share_point(found, point);
}

void Caps::reserve(std::size_t crossings_expected)
{
    reserve_touched(triangles, crossings_expected);
    reserve_touched(order, crossings_expected);
    reserve_touched(piece_shells, crossings_expected);
}

}  // namespace kerf::core::halfedge
