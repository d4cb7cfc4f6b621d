#include "halfedge/cut/stitch.h"

#include "halfedge/cut/irregular/irregular.h"

namespace kerf::core::halfedge {

std::size_t plan_stitch(Universe& u, const Found& found, const Section& section, const Caps& caps, StitchPlan& plan)
{
    const auto index = [](std::size_t i) { return static_cast<Index>(i); };
    const std::size_t cuts = section.cut_points.size(), crossings = found.crossings.size(),
                      outline_edges = found.outline_edge_count();
    const std::size_t cap_count = caps.triangles.size();
    plan.points0 = index(u.mesh.points());
    plan.edges0 = index(u.mesh.edges());
    plan.faces0 = index(u.mesh.faces());
    plan.first_diagonal = index(plan.edges0 + cuts);
    plan.first_section = index(plan.first_diagonal + crossings);
    plan.first_in_plane = index(plan.first_section + 2 * crossings);
    plan.first_cap_edge = index(plan.first_in_plane + found.in_plane.size());
    plan.first_cap_face = index(plan.faces0 + 2 * crossings);
    plan.cap_count = index(cap_count);

    plan.edge_is_closed.assign(outline_edges, false);
    for (const auto& pair : section.cancelled)
        for (const OutlineEdgeId edge : pair) plan.edge_is_closed[edge.number()] = true;
    // Edges inside the caps are numbered by the first of their two triangles.
    plan.cap_edges.assign(3 * cap_count, HalfedgeId());
    plan.cap_edge_count = 0;
    for (std::size_t t = 0; t < cap_count; ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const CapLink link = caps.triangles[t].link[i];
            if (link.is_outline()) {
                plan.edge_is_closed[section.loop_edges[link.outline_edge()].number()] = true;
            } else if (!plan.cap_edges[3 * t + i].is_valid()) {
                const HalfedgeId h = first_halfedge(EdgeId(int(plan.first_cap_edge + plan.cap_edge_count)));
                plan.cap_edges[3 * t + i] = h;
                plan.cap_edges[link.edge()] = opposite(h);
                ++plan.cap_edge_count;
            }
        }

    plan.cap_halfedges.resize(2 * outline_edges);
    plan.vanished.clear();
    plan.boundary.clear();
    plan.touched.clear();
    plan.orbit_start.clear();
    plan.orbit_label.clear();
    plan.order.clear();
    // Contractions move at most one half-edge each.
    const std::size_t contractions = 3 * crossings + 2 * section.cancelled.size();
    plan.boundary.reserve(2 * (section.boundary_cuts.size() + outline_edges) + contractions);
    plan.points = 2 * cuts;
    if (needs_orbits(section)) {
        // Contractions touch two half-edges each; orbits start at corners of sub-triangles and caps and at each
        // outline edge.
        const std::size_t corners = 9 * crossings + 6 * cap_count + 6 * outline_edges + 6 * contractions;
        plan.vanished.reserve(3 * crossings);
        plan.touched.reserve(2 * contractions);
        plan.orbit_start.reserve(corners);
        plan.orbit_label.reserve(corners);
        plan.order.reserve(corners);
        // Every point of the outline may fall apart into one vertex for each end of an outline edge.
        plan.points += 4 * outline_edges + 6 * cap_count;
    }
    plan.edges = cuts + 3 * crossings + found.in_plane.size() + 2 * std::size_t(plan.cap_edge_count);
    plan.faces = 2 * crossings + 2 * cap_count;
    return u.mesh.make_room(plan.points, plan.edges, plan.faces);
}

namespace {

/// One run over the mesh, in steps.
class StitchRun
{
public:
    StitchRun(StitchPlan& plan, Universe& universe, const Found& found, const Section& section, const Caps& caps)
        : plan_(plan), mesh_(universe.mesh), found_(found), section_(section), caps_(caps)
    {
    }

    void run()
    {
        mesh_.resize(plan_.points0 + 2 * section_.cut_points.size(), plan_.edges0 + plan_.edges,
                     plan_.faces0 + plan_.faces);
        for (Index j = 0; j < section_.cut_points.size(); ++j)
            for (const Side side : {Side::negative, Side::positive})
                mesh_.set_position(plan_.cut_point(CutPointId(j), side), section_.cut_points[j]);

        for (const BoundaryCut& cut : section_.boundary_cuts) divide_boundary(cut);
        for (Index c = 0; c < found_.crossings.size(); ++c) {
            constexpr Index kAhead = 8;
            if (c + kAhead < found_.crossings.size()) prefetch(found_.crossings[c + kAhead]);
            divide(c);
        }
        open_in_plane_edges(found_, plan_, mesh_);
        if (section_.is_irregular() || !section_.cancelled.empty()) contract(section_.cancelled, plan_, mesh_);
        for (Index t = 0; t < caps_.triangles.size(); ++t) sew_cap(t);
        collect_open_edges();
        if (needs_orbits(section_)) split_points(found_, section_, caps_, plan_, mesh_);
        for (const HalfedgeId h : plan_.boundary) link_boundary(h);
    }

private:
    /// The two parts of half-edge h, which runs from side `from` to the other side and is divided at a cut point.
    std::array<HalfedgeId, 2> parts(HalfedgeId h, CutPointId cut_point, Side from) const
    {
        const HalfedgeId negative = plan_.negative_half(h, cut_point);
        return from == Side::positive ? std::array{h, negative} : std::array{negative, h};
    }

    // ----- dividing -----

    void divide_boundary(const BoundaryCut& cut)
    {
        const HalfedgeId h = cut.halfedge;
        const bool to_positive = mesh_.to(h) == cut.positive_end;
        const PointId a = to_positive ? cut.negative_end : cut.positive_end;
        const PointId b = to_positive ? cut.positive_end : cut.negative_end;
        const Side from = to_positive ? Side::negative : Side::positive;
        const auto [first, second] = parts(h, cut.cut_point, from);
        const HalfedgeId before = mesh_.prev(h), after = mesh_.next(h);
        move_outgoing(mesh_, a, h, first);
        mesh_.link(before, first);
        mesh_.link(second, after);
        mesh_.set_to(first, plan_.cut_point(cut.cut_point, from));
        mesh_.set_to(second, b);
        mesh_.set_face(first, FaceId());
        mesh_.set_face(second, FaceId());
        plan_.boundary.push_back(first);
        plan_.boundary.push_back(second);
    }

    /// Asks for the memory that divide() will read.
    void prefetch(const Crossing& c) const
    {
        for (const HalfedgeId h : c.halfedge) mesh_.prefetch(h);
        mesh_.prefetch(c.point[static_cast<std::size_t>(c.lone())]);
        mesh_.prefetch(c.point[static_cast<std::size_t>(c.previous())]);
    }

    void divide(Index number)
    {
        const Crossing& c = found_.crossings[number];
        const auto lone = static_cast<std::size_t>(c.lone()), next = static_cast<std::size_t>(c.next()),
                   previous = static_cast<std::size_t>(c.previous());
        const Side near = c.split.lone_side, far = opposite(near);
        const std::uint8_t n = c.split.next_code, p = c.split.previous_code;

        // Half-edges along lone -> next and previous -> lone; a part of no length has no half-edge.
        const HalfedgeId h_n = c.halfedge[lone], h_p = c.halfedge[previous];
        std::array<HalfedgeId, 2> along_n, along_p;
        if (c.n_cut_point().is_valid())
            along_n = parts(h_n, c.n_cut_point(), near);
        else
            along_n = n == lone ? std::array{HalfedgeId(), h_n} : std::array{h_n, HalfedgeId()};
        if (c.p_cut_point().is_valid())
            along_p = parts(h_p, c.p_cut_point(), far);
        else
            along_p = p == lone ? std::array{h_p, HalfedgeId()} : std::array{HalfedgeId(), h_p};
        if (along_n[0].is_valid()) move_outgoing(mesh_, c.point[lone], h_n, along_n[0]);
        if (along_p[0].is_valid()) move_outgoing(mesh_, c.point[previous], h_p, along_p[0]);

        const HalfedgeId near_section = plan_.section_halfedge(number, near),
                         far_section = plan_.section_halfedge(number, far);
        const HalfedgeId diagonal = plan_.diagonal(number);
        const OutlineEdgeId edge = found_.edge_of_crossing(number);
        if (c.split.has_section_edge()) {
            plan_.cap_halfedge(edge, near) = opposite(near_section);
            plan_.cap_halfedge(edge, far) = opposite(far_section);
        } else {
            plan_.cap_halfedge(edge, near) = plan_.cap_halfedge(edge, far) = HalfedgeId();
        }

        const auto faces = plan_.sub_faces(c, number);
        write(c, faces[0], {along_n[0], near_section, along_p[1]});
        if (diagonal_from_n(c)) {
            write(c, faces[1], {along_n[1], c.halfedge[next], diagonal});
            write(c, faces[2], {opposite(diagonal), along_p[0], far_section});
        } else {
            write(c, faces[1], {along_n[1], diagonal, far_section});
            write(c, faces[2], {c.halfedge[next], along_p[0], opposite(diagonal)});
        }

        if (c.n_cut_point().is_valid()) {
            mesh_.set_halfedge_of(plan_.cut_point(c.n_cut_point(), near), near_section);
            mesh_.set_halfedge_of(plan_.cut_point(c.n_cut_point(), far), along_n[1]);
        }
        if (c.p_cut_point().is_valid()) {
            mesh_.set_halfedge_of(plan_.cut_point(c.p_cut_point(), near), along_p[1]);
            mesh_.set_halfedge_of(plan_.cut_point(c.p_cut_point(), far), far_section);
        }
    }

    PointId point_of(const Crossing& c, std::uint8_t code, Side side) const
    {
        if (code == TriangleSplit::kCutNext) return plan_.cut_point(c.n_cut_point(), side);
        if (code == TriangleSplit::kCutPrevious) return plan_.cut_point(c.p_cut_point(), side);
        return c.point[code];
    }

    /// Writes a sub-triangle as a face; one that vanished becomes a face of the two half-edges that it has left.
    void write(const Crossing& c, const SubFace& sub, const std::array<HalfedgeId, 3>& h)
    {
        const auto& code = sub.corners;
        if (sub.exists) {
            mesh_.set_triangle(sub.face, h[0], h[1], h[2]);
            for (std::size_t i = 0; i < 3; ++i) mesh_.set_to(h[i], point_of(c, code[(i + 1) % 3], sub.side));
            return;
        }
        mesh_.set_halfedge_of(sub.face, HalfedgeId());
        std::array<HalfedgeId, 2> left;
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (code[i] == code[(i + 1) % 3]) continue;
            mesh_.set_to(h[i], point_of(c, code[(i + 1) % 3], sub.side));
            left[count++] = h[i];
        }
        if (count < 2) return;
        mesh_.link(left[0], left[1]);
        mesh_.link(left[1], left[0]);
        mesh_.set_face(left[0], sub.face);
        mesh_.set_face(left[1], sub.face);
        mesh_.set_halfedge_of(sub.face, left[0]);
        plan_.vanished.push_back(sub.face);
    }

    // ----- caps -----

    /// The point at a point of the outline; none if that is still to be found.
    PointId point_at(Index loop_point, Side side) const
    {
        if (is_shared_point(found_, section_, loop_point)) return PointId();
        return plan_.cut_point(found_.crossing(section_.loop_edges[loop_point]).entry_cut_point, side);
    }

    void sew_cap(Index t)
    {
        const CapTriangle& cap = caps_.triangles[t];
        std::array<HalfedgeId, 3> negative, positive;
        for (std::size_t i = 0; i < 3; ++i) {
            if (const CapLink link = cap.link[i]; link.is_outline()) {
                const OutlineEdgeId edge = section_.loop_edges[link.outline_edge()];
                negative[i] = plan_.cap_halfedge(edge, Side::negative);
                positive[i] = plan_.cap_halfedge(edge, Side::positive);
            } else {
                negative[i] = plan_.cap_edges[std::size_t{3} * t + i];
                positive[i] = plan_.on_positive_side(negative[i]);
            }
            mesh_.set_to(negative[i], point_at(cap.corner[(i + 1) % 3], Side::negative));
            mesh_.set_to(positive[i], point_at(cap.corner[i], Side::positive));
        }
        mesh_.set_triangle(plan_.cap_face(Side::negative, t), negative[0], negative[1], negative[2]);
        // The same triangle seen from the other side: corners 0, 2, 1.
        mesh_.set_triangle(plan_.cap_face(Side::positive, t), positive[2], positive[1], positive[0]);
    }

    void collect_open_edges()
    {
        for (OutlineEdgeId edge(0); edge.number() < plan_.edge_is_closed.size(); ++edge) {
            if (plan_.edge_is_closed[edge.number()] || !found_.has_section_edge(edge)) continue;
            for (const Side side : {Side::negative, Side::positive}) {
                const HalfedgeId h = plan_.cap_halfedge(edge, side);
                mesh_.set_face(h, FaceId());
                // As seen in the surface, the section runs from entry to exit on the positive side.
                if (!is_shared_edge(found_, section_, edge)) {
                    const Crossing& c = found_.crossing(edge);
                    mesh_.set_to(h,
                                 plan_.cut_point(side == Side::positive ? c.entry_cut_point : c.exit_cut_point, side));
                }
                plan_.boundary.push_back(h);
            }
        }
    }

    /// Links a boundary half-edge with the one before and the one after it, which are found by rotating through faces.
    void link_boundary(HalfedgeId h)
    {
        if (mesh_.is_boundary(opposite(h))) return;  // an edge that no face is left at
        HalfedgeId next = opposite(h);
        do next = opposite(mesh_.prev(next));
        while (!mesh_.is_boundary(next));
        mesh_.link(h, next);
        HalfedgeId prev = opposite(h);
        do prev = opposite(mesh_.next(prev));
        while (!mesh_.is_boundary(prev));
        mesh_.link(prev, h);
        mesh_.set_halfedge_of(mesh_.from(h), h);
    }

    StitchPlan& plan_;
    SurfaceMesh& mesh_;
    const Found& found_;
    const Section& section_;
    const Caps& caps_;
};

}  // namespace

void stitch(Universe& universe, const Found& found, const Section& section, const Caps& caps, StitchPlan& plan)
{
    StitchRun(plan, universe, found, section, caps).run();
}

}  // namespace kerf::core::halfedge
