#include "halfedge/cut/walk.h"

#include <algorithm>

#include "halfedge/cut/irregular/irregular.h"

namespace kerf::core::halfedge {

namespace {

/// One of the two crossed edges of a triangle.
struct Crossed
{
    bool is_n;            ///< lone -> next, otherwise previous -> lone
    HalfedgeId halfedge;  ///< of this triangle
    VertexId from, to;    ///< its vertices
    const CutPoint* point;
    bool whole;         ///< the cut point is an end point: the edge is not divided
    bool needs_vertex;  ///< a sub-triangle has the cut point as a corner
};

/// Writes vertices at cut points behind those of a universe, which has room for them.
class VerticesBehind
{
public:
    VerticesBehind(Universe& universe, std::size_t& count) : u_(universe), count_(count) {}

    VertexId make(const Crossed& e)
    {
        const Index v = static_cast<Index>(u_.vertices.size() + count_++);
        u_.vertices.data()[v] = interpolate(*e.point, u_.vertex(e.from), u_.vertex(e.to));
        for (Stream& stream : u_.streams) {
            float* values = stream.values.data();
            const std::size_t w = stream.width;
            interpolate(*e.point, values + e.from.number() * w, values + e.to.number() * w, values + v * w,
                        stream.width);
        }
        return VertexId(v);
    }

private:
    Universe& u_;
    std::size_t& count_;
};

/// For outlines that need points alone.
struct NoVertices
{
    static VertexId make(const Crossed&) { return {}; }
};

template <class NewVertices>
class Walk
{
public:
    Walk(NewVertices vertices, const Universe& universe, Found& found, Section& section, std::vector<Index>& run)
        : vertices_(vertices), u_(universe), found_(found), section_(section), run_(run)
    {
    }

    void run()
    {
        for (Index c = 0; c < found_.crossings.size(); ++c)
            if (!found_.crossings[c].walked) trace(c);
    }

private:
    Crossed crossed(const Crossing& c, bool exit) const
    {
        Crossed e;
        e.is_n = exit != c.lone_positive();
        const int from = e.is_n ? c.lone() : c.previous(), to = e.is_n ? c.next() : c.lone();
        e.halfedge = c.halfedge[static_cast<std::size_t>(from)];
        e.from = c.corner[static_cast<std::size_t>(from)];
        e.to = c.corner[static_cast<std::size_t>(to)];
        e.point = e.is_n ? &c.split.cut_next : &c.split.cut_previous;
        e.whole = same_position(e.point->position, u_.vertex(e.from).position) ||
                  same_position(e.point->position, u_.vertex(e.to).position);
        e.needs_vertex = e.is_n ? c.split.next_code == TriangleSplit::kCutNext
                                : c.split.previous_code == TriangleSplit::kCutPrevious;
        return e;
    }

    /// Over the exit (or entry) edge to the next crossing triangle; kNone where the run ends.
    Index step(Index from, bool exit)
    {
        Crossing& c = found_.crossings[from];
        const Crossed e = crossed(c, exit);
        if (e.whole) return kNone;

        const CutPointId cut_point(static_cast<Index>(section_.cut_points.size()));
        section_.cut_points.push_back(e.point->position);
        VertexId vertex = e.needs_vertex ? vertices_.make(e) : VertexId();
        (exit ? c.exit_cut_point : c.entry_cut_point) = cut_point;
        (exit ? c.exit_vertex : c.entry_vertex) = vertex;

        const Index to = e.is_n ? c.beyond_n : c.beyond_p;
        if (to == kNone) {
            const HalfedgeId outer = opposite(e.halfedge);
            // A half-edge that leaves through the exit runs from negative to positive.
            const PointId a = u_.mesh.to(outer), b = u_.mesh.to(e.halfedge);
            section_.boundary_cuts.push_back({outer, cut_point, exit ? b : a, exit ? a : b});
            return kNone;
        }
        Crossing& d = found_.crossings[to];
        const Crossed f = crossed(d, !exit);
        if (f.needs_vertex && !(vertex.is_valid() && f.from == e.to && f.to == e.from)) vertex = vertices_.make(f);
        (exit ? d.entry_cut_point : d.exit_cut_point) = cut_point;
        (exit ? d.entry_vertex : d.exit_vertex) = f.needs_vertex ? vertex : VertexId();
        return to;
    }

    void trace(Index start)
    {
        run_.clear();
        Index c = start;
        while (c != kNone && !found_.crossings[c].walked) {
            found_.crossings[c].walked = true;
            run_.push_back(c);
            c = step(c, true);
        }
        const bool closed = c == start;
        if (!closed) {
            // The walk ended: what lies before the start is still missing.
            const std::size_t forward = run_.size();
            for (c = step(start, false); c != kNone && !found_.crossings[c].walked; c = step(c, false)) {
                found_.crossings[c].walked = true;
                run_.push_back(c);
            }
            std::reverse(run_.begin() + static_cast<std::ptrdiff_t>(forward), run_.end());
            std::rotate(run_.begin(), run_.begin() + static_cast<std::ptrdiff_t>(forward), run_.end());
        }
        // Two triangles that share both crossed edges, back to back: the section runs forth and back.
        if (closed && run_.size() == 2) section_.coincidences.irregular = true;
        // Coincidences change what follows what: then the outline is linked by its points instead.
        if (section_.is_irregular()) return;
        Loop loop;
        loop.first = section_.loop_edges.size();
        loop.count = run_.size();
        loop.closed = closed;
        loop.solid = u_.group(found_.crossings[start].group).solid;
        loop.shell = found_.crossings[start].shell;
        for (const Index i : run_) {
            section_.loop_edges.push_back(found_.edge_of_crossing(i));
            section_.loop_points.push_back(section_.position_of(found_.crossings[i].entry_cut_point));
        }
        if (!closed) loop.end = section_.position_of(found_.crossings[run_.back()].exit_cut_point);
        section_.loops.push_back(loop);
    }

    NewVertices vertices_;
    const Universe& u_;
    Found& found_;
    Section& section_;
    std::vector<Index>& run_;
};

}  // namespace

void Walker::reserve(std::size_t crossings_expected)
{
    reserve_touched(run_, crossings_expected);
}

template <class NewVertices>
void Walker::run_with(NewVertices vertices, const Universe& universe, const Plane& plane,
                      const Coincidences& coincidences, OutlineLinker& linker, Found& found, Section& section)
{
    section.coincidences = coincidences;
    Walk(vertices, universe, found, section, run_).run();
    section.cut_point_is_shared.assign(section.cut_points.size(), 0);
    if (section.is_irregular()) {
        section.clear_loops();
        linker.link(universe, plane, found, section);
    }
    section.loops_on_shell.assign(found.shells.size(), 0);
    for (const Loop& loop : section.loops) ++section.loops_on_shell[loop.shell];
}

void Walker::run(Universe& universe, const Plane& plane, const Coincidences& coincidences, OutlineLinker& linker,
                 Found& found, Section& section)
{
    run_with(VerticesBehind(universe, section.new_vertices), universe, plane, coincidences, linker, found, section);
}

void Walker::run_outline(const Universe& universe, const Plane& plane, const Coincidences& coincidences,
                         OutlineLinker& linker, Found& found, Section& section)
{
    run_with(NoVertices(), universe, plane, coincidences, linker, found, section);
}

}  // namespace kerf::core::halfedge
