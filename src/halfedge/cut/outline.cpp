#include "halfedge/cut/outline.h"

#include <algorithm>
#include <optional>

#include "common/cutting/section_ends.h"
#include "halfedge/cut/split.h"

namespace kerf::core::halfedge {

namespace {

/// Leaves a workspace empty, also if memory runs out.
class Emptied
{
public:
    explicit Emptied(CutWorkspace& workspace) : w_(workspace) {}
    ~Emptied() { w_.clear(); }
    Emptied(const Emptied&) = delete;
    Emptied& operator=(const Emptied&) = delete;

private:
    CutWorkspace& w_;
};

/// The corners of a triangle that an outline edge lies in; of an edge in the plane both of its ends.
Triangle corners_of(const Found& found, OutlineEdgeId edge)
{
    if (found.is_crossing(edge)) {
        const auto& [a, b, c] = found.crossing(edge).corner;
        return {a.number(), b.number(), c.number()};
    }
    const InPlaneEdge& e = found.in_plane_edge(edge);
    return {e.start_vertex.number(), e.end_vertex.number(), e.end_vertex.number()};
}

void add_ends(const Universe& u, const Plane& plane, const Found& found, const Section& from, PlaneSection& section)
{
    for (std::size_t i = 0; i < section.paths.size(); ++i) {
        const PlaneSection::Path& path = section.paths[i];
        section.for_each_edge(path, [&](std::size_t e, const glm::vec3& p, const glm::vec3& q) {
            add_section_ends(plane, {u.vertices.data(), u.vertices.size()}, u.streams,
                             corners_of(found, from.loop_edges[from.loops[i].first + e]), p, q, section);
        });
    }
}

}  // namespace

void copy_paths(const Universe& u, const Found& found, const Section& from, PlaneSection& to)
{
    to.points.reserve(from.loop_points.size() + from.loops.size());
    to.edges.reserve(from.loop_edges.size());
    to.paths.reserve(from.loops.size());
    for (const Loop& loop : from.loops) {
        to.paths.push_back({to.points.size(), loop.count + (loop.closed ? 0 : 1), to.edges.size(), loop.count,
                            loop.solid, loop.closed});
        const auto first = from.loop_points.begin() + static_cast<std::ptrdiff_t>(loop.first);
        to.points.insert(to.points.end(), first, first + static_cast<std::ptrdiff_t>(loop.count));
        if (!loop.closed) to.points.push_back(loop.end);
        for (std::size_t i = loop.first; i < loop.first + loop.count; ++i) {
            const OutlineEdgeId edge = from.loop_edges[i];
            to.edges.push_back({found.source_of(u, edge), u.group(found.group_of(edge)).material});
        }
    }
}

void find_outline(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane, CutWorkspace& w,
                  PlaneSection& section)
{
    if (const std::optional<Side> side = missed_side(u, shells, plane, w.waiting_nodes, section.nodes_visited)) {
        section.side_of_object = *side;
        return;
    }
    if (!w.quick_outline.find(u, shells, plane, section)) find_outline_as_a_cut(u, shells, plane, w, section);
}

void find_outline_as_a_cut(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane, CutWorkspace& w,
                           PlaneSection& section)
{
    const Emptied emptied(w);
    w.finder.run(u, shells, plane, w.section_numbers, w.found);
    const Coincidences coincidences = split_crossings(u, w.section_numbers, w.found);
    section.nodes_visited += w.found.nodes_visited;
    section.triangles_touched = w.found.entries.size() + w.found.triangles_read;
    // All of a side can vanish: a spike so thin that its cut points are one.
    for (const Side side : kSides)
        if (!w.found.keeps_triangles(side)) {
            section.side_of_object = opposite(side);
            return;
        }
    w.walker.run_outline(u, plane, coincidences, w.outline_linker, w.found, w.section);
    copy_paths(u, w.found, w.section, section);
    if (section.wants_ends) add_ends(u, plane, w.found, w.section, section);
    section.crossing_triangles = w.found.crossings.size();
    const bool closed = std::ranges::all_of(section.paths, &PlaneSection::Path::closed);
    section.status = closed ? Status::done : Status::open_section;
}

}  // namespace kerf::core::halfedge
