#include "halfedge/cut/irregular/irregular.h"

namespace kerf::core::halfedge {

void list_outline_edges(const Universe& u, const Found& found, const Section& section, std::vector<OutlineEdge>& edges)
{
    edges.clear();
    edges.reserve(section.outline.size());
    for (const ClassedEdge& e : section.outline) edges.push_back({e.from, e.to, {}, found.source_of(u, e.id)});
}

void OutlineLinker::link(const Universe& u, const Plane& plane, const Found& found, Section& section)
{
    collect_edges(u, found, section);
    cancel_edges(u, found, section);
    tags_.clear();
    for (const ClassedEdge& e : section.outline) tags_.push_back(u.group(found.group_of(e.id)).solid);
    divide(u, plane, found, section);
}

void OutlineLinker::relink(const Universe& u, const Plane& plane, const Found& found, const Pieces& pieces,
                           Section& section)
{
    section.clear_loops();
    tags_.clear();
    for (const ClassedEdge& e : section.outline) {
        BySide<Index> piece_shell = pieces.shells_of(found, e.id);
        for (const Side side : {Side::negative, Side::positive})
            if (found.bounds_nothing(e.id, side)) piece_shell[side] = kNone;
        tags_.push_back(std::uint64_t{piece_shell[Side::negative]} << 32 | piece_shell[Side::positive]);
    }
    divide(u, plane, found, section);
}

/// Collects the outline edges with the classes of their ends, and says which cut points are shared.
void OutlineLinker::collect_edges(const Universe& u, const Found& found, Section& section)
{
    classes_.begin(u, found, section);
    const auto add = [&](OutlineEdgeId outline_edge, Index from, Index to) {
        from = classes_.find(from);
        to = classes_.find(to);
        if (from != to) section.outline.push_back({outline_edge, from, to});
    };
    for (Index i = 0; i < found.crossings.size(); ++i) {
        const Crossing& c = found.crossings[i];
        if (!c.split.has_section_edge()) continue;
        const Index from = classes_.of_code(c, c.split.section_from);
        add(found.edge_of_crossing(i), from, classes_.of_code(c, c.split.section_to));
    }
    for (Index i = 0; i < found.in_plane.size(); ++i) {
        // As seen in the positive side's surface.
        const HalfedgeId h = found.in_plane[i].positive_halfedge;
        const Index from = classes_.of_point(u.mesh.from(h));
        add(found.edge_in_plane(i), from, classes_.of_point(u.mesh.to(h)));
    }
    // A cut point that is alone is one vertex on each side.
    members_.assign(classes_.size(), 0);
    for (Index i = 0; i < classes_.size(); ++i) ++members_[classes_.find(i)];
    for (Index i = 0; i < section.cut_points.size(); ++i)
        section.cut_point_is_shared[i] = members_[classes_.find(i)] > 1 ? 1 : 0;
    section.any_shared = true;
    section.outline_points.resize(classes_.size());
    for (Index i = 0; i < classes_.size(); ++i) section.outline_points[i] = classes_.position(i);
}

/// Takes out pairs of outline edges that run forth and back.
void OutlineLinker::cancel_edges(const Universe& u, const Found& found, Section& section)
{
    is_gone_.assign(section.outline.size(), 0);
    list_outline_edges(u, found, section, edges_);
    for (const auto& [a, b] : opposite_.find(section.outline_points.size(), edges_)) {
        section.cancelled.push_back({section.outline[a].id, section.outline[b].id});
        is_gone_[a] = is_gone_[b] = 1;
    }
    if (section.cancelled.empty()) return;
    std::size_t kept = 0;
    for (Index i = 0; i < section.outline.size(); ++i)
        if (is_gone_[i] == 0) section.outline[kept++] = section.outline[i];
    section.outline.resize(kept);
}

/// Divides the outline into loops and chains, those of one tag after one another.
void OutlineLinker::divide(const Universe& u, const Plane& plane, const Found& found, Section& section)
{
    list_outline_edges(u, found, section, edges_);
    const DividedOutline& divided = divider_.divide(plane, section.outline_points, edges_, tags_);
    for (const OutlinePath& path : divided.paths) {
        const auto edge = [&](std::size_t i) -> const ClassedEdge& {
            return section.outline[divided.edges[path.first + i]];
        };
        Loop loop;
        loop.first = section.loop_edges.size();
        loop.count = path.count;
        // What bounds nothing on a side is no loop to be closed.
        loop.closed = path.closed && !found.bounds_nothing(edge(0).id, Side::negative) &&
                      !found.bounds_nothing(edge(0).id, Side::positive);
        loop.solid = u.group(found.group_of(edge(0).id)).solid;
        loop.shell = found.shell_of(edge(0).id);
        for (std::size_t i = 0; i < path.count; ++i) {
            section.loop_edges.push_back(edge(i).id);
            section.loop_points.push_back(section.outline_points[edge(i).from]);
        }
        if (!loop.closed) loop.end = section.outline_points[edge(path.count - 1).to];
        section.loops.push_back(loop);
    }
}

}  // namespace kerf::core::halfedge
