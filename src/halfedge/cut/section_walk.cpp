#include <algorithm>
#include <unordered_map>

#include "halfedge/cut/cut_plan.h"
#include "halfedge/cut/outline.h"

// WALK: from every crossing triangle not seen yet over opposite half-edges until the loop closes or ends; one new point
// for each crossed edge, one new vertex for each crossed edge and attribute. O(k).

namespace kerf::halfedge {

namespace {

/// Notes what is special about a triangle whose cut points coincide with corners or with each other.
void note_coincidences(const Universe& u, const Crossing& c, CutScratch& s)
{
    s.irregular = true;
    for (const auto& [code, own] : {std::pair{c.split.next_code, TriangleSplit::kCutNext},
                                    std::pair{c.split.previous_code, TriangleSplit::kCutPrevious}}) {
        if (code == own) continue;
        if (code >= 3 || c.distance[code] != 0.0) s.collapsed = true;
        if (code < 3 && u.mesh.is_boundary(u.mesh.halfedge_of_vertex(c.point[code]))) s.meets_boundary = true;
    }
}

}  // namespace

void split_crossings(const Universe& u, CutScratch& s)
{
    // What a triangle leads to is asked for some triangles ahead: its face, then its half-edges.
    constexpr std::size_t kAhead = 8;
    const std::size_t count = s.crossings.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i + 2 * kAhead < count) u.mesh.prefetch_face(s.crossings[i + 2 * kAhead].face);
        if (i + kAhead < count) u.mesh.prefetch_halfedge(u.mesh.halfedge_of_face(s.crossings[i + kAhead].face));
        if (i + kAhead / 2 < count) {
            const Index h = u.mesh.halfedge_of_face(s.crossings[i + kAhead / 2].face);
            u.mesh.prefetch_halfedge(u.mesh.next(h));
            u.mesh.prefetch_halfedge(u.mesh.prev(h));
        }
        Crossing& c = s.crossings[i];
        c.split = split_triangle(
            {u.vertices[c.corner[0]].position, u.vertices[c.corner[1]].position, u.vertices[c.corner[2]].position},
            c.distance);
        c.walked = false;
        c.entry_cut_point = c.exit_cut_point = c.entry_vertex = c.exit_vertex = kNone;
        Index h = u.mesh.halfedge_of_face(c.face);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            c.halfedge[corner] = h;
            c.point[(corner + 1) % 3] = u.mesh.to(h);
            h = u.mesh.next(h);
        }
        if (c.split.next_code != TriangleSplit::kCutNext || c.split.previous_code != TriangleSplit::kCutPrevious)
            note_coincidences(u, c, s);
    }
    if (!s.in_plane.empty()) s.irregular = true;
    for (const InPlaneEdge& e : s.in_plane)
        for (const Index h : {e.negative_halfedge, e.positive_halfedge})
            if (u.mesh.is_boundary(u.mesh.halfedge_of_vertex(u.mesh.to(h)))) s.meets_boundary = true;
}

namespace {

class Walker
{
public:
    Walker(Universe& universe, CutScratch& scratch) : u_(universe), s_(scratch) {}

    void run()
    {
        for (Index c = 0; c < s_.crossings.size(); ++c)
            if (!s_.crossings[c].walked) trace(c);
    }

private:
    /// One of the two crossed edges of a triangle.
    struct Crossed
    {
        bool is_n;       ///< lone -> next, otherwise previous -> lone
        Index halfedge;  ///< of this triangle
        Index from, to;  ///< its vertices
        const CutPoint* point;
        bool whole;         ///< the cut point is an end point: the edge is not divided
        bool needs_vertex;  ///< a piece of this triangle has the cut point as a corner
    };

    Crossed crossed(const Crossing& c, bool exit) const
    {
        Crossed e;
        e.is_n = exit != c.lone_positive();
        const int from = e.is_n ? c.lone() : c.previous(), to = e.is_n ? c.next() : c.lone();
        e.halfedge = c.halfedge[static_cast<std::size_t>(from)];
        e.from = c.corner[static_cast<std::size_t>(from)];
        e.to = c.corner[static_cast<std::size_t>(to)];
        e.point = e.is_n ? &c.split.cut_next : &c.split.cut_previous;
        e.whole = same_position(e.point->position, u_.vertices[e.from].position) ||
                  same_position(e.point->position, u_.vertices[e.to].position);
        e.needs_vertex = e.is_n ? c.split.next_code == TriangleSplit::kCutNext
                                : c.split.previous_code == TriangleSplit::kCutPrevious;
        return e;
    }

    Index new_vertex(const Crossed& e)
    {
        const Index v = static_cast<Index>(u_.vertices.size() + s_.new_vertices++);
        u_.vertices.data()[v] = interpolate(*e.point, u_.vertices[e.from], u_.vertices[e.to]);
        for (Stream& stream : u_.streams) {
            float* values = stream.values.data();
            const std::size_t w = stream.width;
            interpolate(*e.point, values + e.from * w, values + e.to * w, values + v * w, stream.width);
        }
        return v;
    }

    /// The crossing triangle of a face, or kNone.
    Index crossing_of(Index face) const
    {
        const std::uint64_t stamp = u_.stamp_of_face[face];
        return stamp >= u_.stamp_base && stamp - u_.stamp_base < s_.crossings.size()
                   ? static_cast<Index>(stamp - u_.stamp_base)
                   : kNone;
    }

    /// Over the exit (or entry) edge to the next crossing triangle; kNone where the chain ends.
    Index step(Index from, bool exit)
    {
        Crossing& c = s_.crossings[from];
        const Crossed e = crossed(c, exit);
        if (e.whole) return kNone;

        const Index cut_point = static_cast<Index>(s_.cut_points.size());
        s_.cut_points.push_back(e.point->position);
        Index vertex = e.needs_vertex ? new_vertex(e) : kNone;
        (exit ? c.exit_cut_point : c.entry_cut_point) = cut_point;
        (exit ? c.exit_vertex : c.entry_vertex) = vertex;

        const Index outer = e.halfedge ^ 1u, face = u_.mesh.face(outer);
        if (face == kNone) {
            // A half-edge that leaves through the exit runs from negative to positive.
            const Index a = u_.mesh.to(outer), b = u_.mesh.to(e.halfedge);
            s_.boundary_cuts.push_back({outer, cut_point, exit ? b : a, exit ? a : b});
            return kNone;
        }
        const Index to = crossing_of(face);
        Crossing& d = s_.crossings[to];
        const Crossed f = crossed(d, !exit);
        if (f.needs_vertex && !(vertex != kNone && f.from == e.to && f.to == e.from)) vertex = new_vertex(f);
        (exit ? d.entry_cut_point : d.exit_cut_point) = cut_point;
        (exit ? d.entry_vertex : d.exit_vertex) = f.needs_vertex ? vertex : kNone;
        return to;
    }

    void trace(Index start)
    {
        std::vector<Index>& chain = s_.chain;
        chain.clear();
        Index c = start;
        while (c != kNone && !s_.crossings[c].walked) {
            s_.crossings[c].walked = true;
            chain.push_back(c);
            c = step(c, true);
        }
        const bool closed = c == start;
        if (!closed) {
            // The walk ended: what lies before the start is still missing.
            const std::size_t forward = chain.size();
            for (c = step(start, false); c != kNone && !s_.crossings[c].walked; c = step(c, false)) {
                s_.crossings[c].walked = true;
                chain.push_back(c);
            }
            std::reverse(chain.begin() + static_cast<std::ptrdiff_t>(forward), chain.end());
            std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(forward), chain.end());
        }
        // Two triangles that share both crossed edges, back to back: the section runs forth and back.
        if (closed && chain.size() == 2) s_.irregular = true;
        // Coincidences change what follows what: then the outline is linked by its points instead.
        if (s_.irregular) return;
        Loop loop;
        loop.first = s_.loop_edges.size();
        loop.count = chain.size();
        loop.closed = closed;
        loop.solid = u_.groups[s_.crossings[start].group].solid;
        loop.shell = s_.crossings[start].shell;
        for (const Index i : chain) {
            s_.loop_edges.push_back(i);
            s_.loop_points.push_back(s_.cut_points[s_.crossings[i].entry_cut_point]);
        }
        if (!closed) loop.end = s_.cut_points[s_.crossings[chain.back()].exit_cut_point];
        s_.loops.push_back(loop);
    }

    Universe& u_;
    CutScratch& s_;
};

}  // namespace

void walk_section(Universe& universe, const Plane& plane, CutScratch& scratch)
{
    Walker(universe, scratch).run();
    scratch.cut_point_is_shared.assign(scratch.cut_points.size(), 0);
    if (scratch.irregular) {
        scratch.loops.clear();
        scratch.loop_edges.clear();
        scratch.loop_points.clear();
        link_outline(universe, plane, scratch);
    }
    for (const Loop& loop : scratch.loops) ++scratch.cut_shells[loop.shell].loops;
}

}  // namespace kerf::halfedge
