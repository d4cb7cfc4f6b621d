#include "halfedge/cut/stitch.h"

#include <algorithm>

namespace kerf::halfedge {

namespace {

bool has_section_edge(const CutScratch& s, OutlineEdgeId edge)
{
    return edge >= s.crossings.size() || s.crossings[edge].split.has_section_edge();
}

/// Which diagonal divides the far side of a crossing triangle: N - previous, or next - P. Where pieces vanish it is the
/// diagonal between the corners that coincide.
bool diagonal_from_n(const Crossing& c)
{
    const TriangleSplit& split = c.split;
    if (split.previous_code == c.next()) return false;
    if (split.next_code == c.previous()) return true;
    if (split.sub_triangle_count < 2) return true;
    const SubTriangle& first_far = split.sub_triangle[split.sub_triangle_count - 2u];
    return first_far.side == split.lone_side || first_far.corners[2] == c.previous();
}

}  // namespace

std::array<Stitcher::SubFace, 3> Stitcher::sub_faces(const Crossing& c, Index number, Index first_new_face)
{
    const auto lone = static_cast<std::uint8_t>(c.lone()), next = static_cast<std::uint8_t>(c.next()),
               previous = static_cast<std::uint8_t>(c.previous());
    const std::uint8_t n = c.split.next_code, p = c.split.previous_code;
    const Side near = c.split.lone_side, far = opposite(near);
    const Index f = first_new_face + 2 * number;
    const auto piece = [](Index face, Side side, std::uint8_t i, std::uint8_t j, std::uint8_t k) {
        return SubFace{face, i != j && j != k && k != i, side, {i, j, k}};
    };
    if (diagonal_from_n(c))
        return {piece(c.face, near, lone, n, p), piece(f, far, n, next, previous), piece(f + 1, far, n, previous, p)};
    return {piece(c.face, near, lone, n, p), piece(f, far, n, next, p), piece(f + 1, far, next, previous, p)};
}

std::size_t Stitcher::plan(Universe& u, const CutScratch& s)
{
    const auto index = [](std::size_t i) { return static_cast<Index>(i); };
    const std::size_t cuts = s.cut_points.size(), crossings = s.crossings.size(),
                      outline_edges = crossings + s.in_plane.size();
    const std::size_t caps = s.caps.size();
    vertices0_ = index(u.mesh.vertices());
    edges0_ = index(u.mesh.edges());
    faces0_ = index(u.mesh.faces());
    first_diagonal_ = index(edges0_ + cuts);
    first_section_ = index(first_diagonal_ + crossings);
    first_in_plane_ = index(first_section_ + 2 * crossings);
    first_cap_edge_ = index(first_in_plane_ + s.in_plane.size());
    first_cap_face_ = index(faces0_ + 2 * crossings);
    cap_count_ = index(caps);

    edge_is_closed_.assign(outline_edges, false);
    for (const auto& pair : s.cancelled)
        for (const OutlineEdgeId edge : pair) edge_is_closed_[edge] = true;
    // Edges inside the caps are numbered by the first of their two triangles.
    cap_edge_.assign(3 * caps, kNone);
    cap_edge_count_ = 0;
    for (std::size_t t = 0; t < caps; ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const CapLink link = s.caps[t].link[i];
            if (link.is_outline()) {
                edge_is_closed_[s.loop_edges[link.outline_edge()]] = true;
            } else if (cap_edge_[3 * t + i] == kNone) {
                cap_edge_[3 * t + i] = 2 * (first_cap_edge_ + cap_edge_count_);
                cap_edge_[link.edge()] = cap_edge_[3 * t + i] + 1;
                ++cap_edge_count_;
            }
        }

    cap_half_.resize(2 * outline_edges);
    vanished_.clear();
    boundary_.clear();
    touched_.clear();
    orbit_start_.clear();
    orbit_label_.clear();
    order_.clear();
    // Contractions move at most one half-edge each.
    const std::size_t contractions = 3 * crossings + 2 * s.cancelled.size();
    boundary_.reserve(2 * (s.boundary_cuts.size() + outline_edges) + contractions);
    vertices_ = 2 * cuts;
    if (needs_orbits(s)) {
        // Contractions touch two half-edges each; orbits start at corners of pieces, caps and whatever lies at an
        // outline edge.
        const std::size_t corners = 9 * crossings + 6 * caps + 6 * outline_edges + 6 * contractions;
        vanished_.reserve(3 * crossings);
        touched_.reserve(2 * contractions);
        orbit_start_.reserve(corners);
        orbit_label_.reserve(corners);
        order_.reserve(corners);
        // Every point of the outline may fall apart into one vertex for each end of an outline edge.
        vertices_ += 4 * outline_edges + 6 * caps;
    }
    edges_ = cuts + 3 * crossings + s.in_plane.size() + 2 * std::size_t(cap_edge_count_);
    faces_ = 2 * crossings + 2 * caps;
    return u.mesh.make_room(vertices_, edges_, faces_);
}

/// One run over the mesh, in steps.
class StitchRun
{
public:
    StitchRun(Stitcher& plan, Universe& universe, CutScratch& scratch) : plan_(plan), mesh_(universe.mesh), s_(scratch)
    {
    }

    void run()
    {
        mesh_.resize(plan_.vertices0_ + 2 * s_.cut_points.size(), plan_.edges0_ + plan_.edges_,
                     plan_.faces0_ + plan_.faces_);
        for (Index j = 0; j < s_.cut_points.size(); ++j)
            for (const Side side : {Side::negative, Side::positive})
                mesh_.set_point(cut_vertex(j, side), s_.cut_points[j]);

        for (const BoundaryCut& cut : s_.boundary_cuts) divide_boundary(cut);
        for (Index c = 0; c < s_.crossings.size(); ++c) divide(c);
        for (Index q = 0; q < s_.in_plane.size(); ++q) open_in_plane_edge(q);
        if (s_.irregular || !s_.cancelled.empty()) {
            mark_waiting();
            for (const Index face : plan_.vanished_) contract_face(face);
            for (const auto& [a, b] : s_.cancelled)
                for (const Side side : {Side::negative, Side::positive}) contract(cap_half(a, side), cap_half(b, side));
        }
        for (Index t = 0; t < s_.caps.size(); ++t) sew_cap(t);
        collect_open_edges();
        if (plan_.needs_orbits(s_)) renumber_vertices();
        for (const Index h : plan_.boundary_) link_boundary(h);
    }

private:
    // ----- numbers -----

    Index cut_vertex(Index cut_point, Side side) const
    {
        return plan_.vertices0_ + 2 * cut_point + static_cast<Index>(side);
    }

    Index& cap_half(OutlineEdgeId edge, Side side) { return plan_.cap_half_[2 * edge + static_cast<Index>(side)]; }

    /// The half-edge of a section edge that belongs to the surface; its opposite waits for the cap.
    Index section_half(Index crossing, Side side) const
    {
        return 2 * (plan_.first_section_ + 2 * crossing + static_cast<Index>(side));
    }

    /// The two parts of half-edge h, which runs from side `from` to the other side and is divided at `cut`: the
    /// positive part keeps the number.
    std::array<Index, 2> parts(Index h, Index cut_point, Side from) const
    {
        const Index negative = 2 * (plan_.edges0_ + cut_point) + (h & 1u);
        return from == Side::positive ? std::array{h, negative} : std::array{negative, h};
    }

    // ----- dividing -----

    void move_outgoing(Index vertex, Index from, Index to)
    {
        if (mesh_.halfedge_of_vertex(vertex) == from) mesh_.set_halfedge_of_vertex(vertex, to);
    }

    void divide_boundary(const BoundaryCut& cut)
    {
        const Index h = cut.halfedge;
        const bool to_positive = mesh_.to(h) == cut.positive_end;
        const Index a = to_positive ? cut.negative_end : cut.positive_end;
        const Index b = to_positive ? cut.positive_end : cut.negative_end;
        const Side from = to_positive ? Side::negative : Side::positive;
        const auto [first, second] = parts(h, cut.cut_point, from);
        const Index before = mesh_.prev(h), after = mesh_.next(h);
        move_outgoing(a, h, first);
        mesh_.link(before, first);
        mesh_.link(second, after);
        mesh_.set_to(first, cut_vertex(cut.cut_point, from));
        mesh_.set_to(second, b);
        mesh_.set_face(first, kNone);
        mesh_.set_face(second, kNone);
        plan_.boundary_.push_back(first);
        plan_.boundary_.push_back(second);
    }

    void divide(Index number)
    {
        const Crossing& c = s_.crossings[number];
        const auto lone = static_cast<std::size_t>(c.lone()), next = static_cast<std::size_t>(c.next()),
                   previous = static_cast<std::size_t>(c.previous());
        const Side near = c.split.lone_side, far = opposite(near);
        const std::uint8_t n = c.split.next_code, p = c.split.previous_code;

        // Half-edges along lone -> next and previous -> lone; a part of no length has no half-edge.
        const Index h_n = c.halfedge[lone], h_p = c.halfedge[previous];
        std::array<Index, 2> along_n, along_p;
        if (c.n_cut_point() != kNone)
            along_n = parts(h_n, c.n_cut_point(), near);
        else
            along_n = n == lone ? std::array{kNone, h_n} : std::array{h_n, kNone};
        if (c.p_cut_point() != kNone)
            along_p = parts(h_p, c.p_cut_point(), far);
        else
            along_p = p == lone ? std::array{h_p, kNone} : std::array{kNone, h_p};
        if (along_n[0] != kNone) move_outgoing(c.point[lone], h_n, along_n[0]);
        if (along_p[0] != kNone) move_outgoing(c.point[previous], h_p, along_p[0]);

        const Index near_section = section_half(number, near), far_section = section_half(number, far);
        const Index diagonal = 2 * (plan_.first_diagonal_ + number);
        if (c.split.has_section_edge()) {
            cap_half(number, near) = near_section ^ 1u;
            cap_half(number, far) = far_section ^ 1u;
        } else {
            cap_half(number, near) = cap_half(number, far) = kNone;
        }

        const auto pieces = Stitcher::sub_faces(c, number, plan_.faces0_);
        write(c, pieces[0], {along_n[0], near_section, along_p[1]});
        if (diagonal_from_n(c)) {
            write(c, pieces[1], {along_n[1], c.halfedge[next], diagonal});
            write(c, pieces[2], {diagonal ^ 1u, along_p[0], far_section});
        } else {
            write(c, pieces[1], {along_n[1], diagonal, far_section});
            write(c, pieces[2], {c.halfedge[next], along_p[0], diagonal ^ 1u});
        }

        if (c.n_cut_point() != kNone) {
            mesh_.set_halfedge_of_vertex(cut_vertex(c.n_cut_point(), near), near_section);
            mesh_.set_halfedge_of_vertex(cut_vertex(c.n_cut_point(), far), along_n[1]);
        }
        if (c.p_cut_point() != kNone) {
            mesh_.set_halfedge_of_vertex(cut_vertex(c.p_cut_point(), near), along_p[1]);
            mesh_.set_halfedge_of_vertex(cut_vertex(c.p_cut_point(), far), far_section);
        }
    }

    Index vertex_of(const Crossing& c, std::uint8_t code, Side side) const
    {
        if (code == TriangleSplit::kCutNext) return cut_vertex(c.n_cut_point(), side);
        if (code == TriangleSplit::kCutPrevious) return cut_vertex(c.p_cut_point(), side);
        return c.point[code];
    }

    /// Writes a piece as a face; one that vanished as a face of its two half-edges that are left.
    void write(const Crossing& c, const Stitcher::SubFace& piece, const std::array<Index, 3>& h)
    {
        const auto& code = piece.corners;
        if (piece.exists) {
            mesh_.set_triangle(piece.face, h[0], h[1], h[2]);
            for (std::size_t i = 0; i < 3; ++i) mesh_.set_to(h[i], vertex_of(c, code[(i + 1) % 3], piece.side));
            return;
        }
        mesh_.set_halfedge_of_face(piece.face, kNone);
        std::array<Index, 2> left{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (code[i] == code[(i + 1) % 3]) continue;
            mesh_.set_to(h[i], vertex_of(c, code[(i + 1) % 3], piece.side));
            left[count++] = h[i];
        }
        if (count < 2) return;
        mesh_.link(left[0], left[1]);
        mesh_.link(left[1], left[0]);
        mesh_.set_face(left[0], piece.face);
        mesh_.set_face(left[1], piece.face);
        mesh_.set_halfedge_of_face(piece.face, left[0]);
        plan_.vanished_.push_back(piece.face);
    }

    /// The edge stays with the positive face; the negative face gets an edge of its own.
    void open_in_plane_edge(Index q)
    {
        const InPlaneEdge& e = s_.in_plane[q];
        const OutlineEdgeId edge = static_cast<OutlineEdgeId>(s_.crossings.size()) + q;
        const Index copy = 2 * (plan_.first_in_plane_ + q);
        const Index a = mesh_.from(e.negative_halfedge);
        move_halfedge(e.negative_halfedge, copy);
        move_outgoing(a, e.negative_halfedge, copy);
        mesh_.set_to(copy ^ 1u, a);
        mesh_.set_face(e.negative_halfedge, kNone);
        cap_half(edge, Side::positive) = e.negative_halfedge;
        cap_half(edge, Side::negative) = copy ^ 1u;
    }

    // ----- contracting -----

    // A half-edge that waits for its cap names its place in `cap_half_` by a face number beyond all faces, so that it
    // can be moved.
    Index first_waiting_face() const { return plan_.first_cap_face_ + 2 * plan_.cap_count_; }
    bool is_waiting(Index face) const { return face != kNone && face >= first_waiting_face(); }

    void mark_waiting()
    {
        for (Index i = 0; i < plan_.cap_half_.size(); ++i)
            if (plan_.cap_half_[i] != kNone) mesh_.set_face(plan_.cap_half_[i], first_waiting_face() + i);
    }

    /// Half-edge `from` continues as half-edge `to`.
    void move_halfedge(Index from, Index to)
    {
        const Index face = mesh_.face(from);
        mesh_.set_to(to, mesh_.to(from));
        mesh_.set_face(to, face);
        mesh_.set_face(from, kNone);
        if (is_waiting(face)) {
            plan_.cap_half_[face - first_waiting_face()] = to;
            return;
        }
        if (face == kNone) {
            // At a crossed edge of the boundary its neighbours are not known yet. What dies here is skipped then.
            plan_.boundary_.push_back(to);
            return;
        }
        const Index prev = mesh_.prev(from), next = mesh_.next(from);
        mesh_.link(to, next);
        mesh_.link(prev, to);
        if (mesh_.halfedge_of_face(face) == from) mesh_.set_halfedge_of_face(face, to);
    }

    /// Removes x and y, which bound nothing: what lies across x and what lies across y become opposite.
    void contract(Index x, Index y)
    {
        const Index a = x ^ 1u, b = y ^ 1u;
        mesh_.set_face(x, kNone);
        mesh_.set_face(y, kNone);
        if (a == y) return;
        move_halfedge(b, x);
        plan_.touched_.push_back(a);
        plan_.touched_.push_back(x);
    }

    void contract_face(Index face)
    {
        const Index x = mesh_.halfedge_of_face(face), y = mesh_.next(x);
        mesh_.set_halfedge_of_face(face, kNone);
        contract(x, y);
    }

    // ----- caps -----

    bool is_shared_point(Index loop_point) const
    {
        const OutlineEdgeId edge = s_.loop_edges[loop_point];
        return edge >= s_.crossings.size() || s_.is_shared(s_.crossings[edge].entry_cut_point);
    }

    /// The vertex of the half-edge mesh at a point of the outline; kNone where that is still to be found.
    Index outline_vertex(Index loop_point, Side side) const
    {
        if (is_shared_point(loop_point)) return kNone;
        return cut_vertex(s_.crossings[s_.loop_edges[loop_point]].entry_cut_point, side);
    }

    bool is_shared_edge(OutlineEdgeId edge) const
    {
        return edge >= s_.crossings.size() || s_.is_shared(s_.crossings[edge]);
    }

    void sew_cap(Index t)
    {
        const CapTriangle& cap = s_.caps[t];
        std::array<Index, 3> negative, positive;
        for (std::size_t i = 0; i < 3; ++i) {
            if (const CapLink link = cap.link[i]; link.is_outline()) {
                const OutlineEdgeId edge = s_.loop_edges[link.outline_edge()];
                negative[i] = cap_half(edge, Side::negative);
                positive[i] = cap_half(edge, Side::positive);
            } else {
                negative[i] = plan_.cap_edge_[std::size_t{3} * t + i];
                positive[i] = negative[i] + 2 * plan_.cap_edge_count_;
            }
            mesh_.set_to(negative[i], outline_vertex(cap.corner[(i + 1) % 3], Side::negative));
            mesh_.set_to(positive[i], outline_vertex(cap.corner[i], Side::positive));
        }
        mesh_.set_triangle(plan_.cap_face(Side::negative, t), negative[0], negative[1], negative[2]);
        // The same triangle seen from the other side: corners 0, 2, 1.
        mesh_.set_triangle(plan_.cap_face(Side::positive, t), positive[2], positive[1], positive[0]);
    }

    void collect_open_edges()
    {
        for (OutlineEdgeId edge = 0; edge < plan_.edge_is_closed_.size(); ++edge) {
            if (plan_.edge_is_closed_[edge] || !has_section_edge(s_, edge)) continue;
            for (const Side side : {Side::negative, Side::positive}) {
                const Index h = cap_half(edge, side);
                mesh_.set_face(h, kNone);
                // As seen in the surface, the section runs from entry to exit on the positive side.
                if (!is_shared_edge(edge)) {
                    const Crossing& c = s_.crossings[edge];
                    mesh_.set_to(h, cut_vertex(side == Side::positive ? c.entry_cut_point : c.exit_cut_point, side));
                }
                plan_.boundary_.push_back(h);
            }
        }
    }

    /// Links a boundary half-edge with the one before and the one after it, which are found by rotating through faces.
    void link_boundary(Index h)
    {
        if (mesh_.is_boundary(h ^ 1u)) return;  // an edge that no face is left at
        Index next = h ^ 1u;
        do next = mesh_.prev(next) ^ 1u;
        while (!mesh_.is_boundary(next));
        mesh_.link(h, next);
        Index prev = h ^ 1u;
        do prev = mesh_.next(prev) ^ 1u;
        while (!mesh_.is_boundary(prev));
        mesh_.link(prev, h);
        mesh_.set_halfedge_of_vertex(mesh_.from(h), h);
    }

    // ----- vertices -----

    /// Makes each umbrella at a shared point one vertex. A vertex in the plane whose faces are divided between the
    /// sides, or that several loops run through, falls apart; cut points that coincide become one. Every such umbrella
    /// has a face that is a piece, a cap triangle, lies at an outline edge or was glued.
    void renumber_vertices()
    {
        for (Index c = 0; c < s_.crossings.size(); ++c) {
            if (!s_.is_shared(s_.crossings[c])) continue;
            for (const Stitcher::SubFace& piece : Stitcher::sub_faces(s_.crossings[c], c, plan_.faces0_))
                if (piece.exists) start_orbits(piece.face);
        }
        for (Index t = 0; t < s_.caps.size(); ++t) {
            const auto& corner = s_.caps[t].corner;
            if (std::none_of(corner.begin(), corner.end(), [&](Index p) { return is_shared_point(p); })) continue;
            for (const Side side : {Side::negative, Side::positive}) start_orbits(plan_.cap_face(side, t));
        }
        for (OutlineEdgeId edge = 0; edge < plan_.edge_is_closed_.size(); ++edge) {
            if (!is_shared_edge(edge) || !has_section_edge(s_, edge)) continue;
            for (const Side side : {Side::negative, Side::positive}) {
                const Index face = mesh_.face(cap_half(edge, side) ^ 1u);
                if (face != kNone) start_orbits(face);
            }
        }
        for (const Index h : plan_.touched_)
            if (mesh_.face(h) != kNone) start_orbits(mesh_.face(h));

        // The first orbit with a label keeps it; all others with the same label get new vertices.
        auto& label = plan_.orbit_label_;
        auto& order = plan_.order_;
        for (Index i = 0; i < label.size(); ++i) order.push_back(i);
        std::sort(order.begin(), order.end(),
                  [&](Index a, Index b) { return label[a] != label[b] ? label[a] < label[b] : a < b; });
        Index vertices = static_cast<Index>(mesh_.vertices());
        const Index first_extra = vertices;
        for (std::size_t i = 0; i < order.size(); ++i)
            if (label[order[i]] == kNone || (i > 0 && label_of_previous(i) == label[order[i]])) ++vertices;
        mesh_.resize(vertices, mesh_.edges(), mesh_.faces());
        Index extra = first_extra;
        Index before = kNone;
        for (const Index i : order) {
            const Index wanted = label[i];
            Index vertex = wanted;
            if (wanted == kNone || wanted == before) {
                vertex = extra++;
                mesh_.set_point(vertex, wanted != kNone ? mesh_.point(wanted) : cap_corner(plan_.orbit_start_[i]));
            }
            before = wanted;
            Index leaving = kNone, arriving = kNone;
            for_each_outgoing(mesh_, plan_.orbit_start_[i], [&](Index h) {
                mesh_.set_to(h ^ 1u, vertex);
                if (mesh_.is_boundary(h)) leaving = h;
                if (mesh_.is_boundary(h ^ 1u)) arriving = h ^ 1u;
            });
            mesh_.set_halfedge_of_vertex(vertex, leaving != kNone ? leaving : plan_.orbit_start_[i]);
            // Where loops and chains meet at the boundary caps may put other boundary edges together than before.
            if (leaving != kNone && arriving != kNone) mesh_.link(arriving, leaving);
        }
    }

    Index label_of_previous(std::size_t i) const { return plan_.orbit_label_[plan_.order_[i - 1]]; }

    static constexpr Index kOrbitMark = Index(1) << 30;  // no mesh has that many vertices

    /// Starts an orbit at each corner of a face that no orbit has reached yet. Reached half-edges get the orbit's
    /// number.
    void start_orbits(Index face)
    {
        Index start = mesh_.halfedge_of_face(face);
        for (int i = 0; i < 3; ++i, start = mesh_.next(start)) {
            const Index reached = mesh_.to(start ^ 1u);
            if (reached != kNone && reached >= kOrbitMark) continue;
            const Index mark = kOrbitMark + static_cast<Index>(plan_.orbit_start_.size());
            Index label = kNone;
            for_each_outgoing(mesh_, start, [&](Index h) {
                // What faces of the surface say; corners of new caps don't know.
                if (!mesh_.is_boundary(h) && mesh_.face(h) < plan_.first_cap_face_)
                    label = std::min(label, unmarked_origin(h));
            });
            for_each_outgoing(mesh_, start, [&](Index h) { mesh_.set_to(h ^ 1u, mark); });
            plan_.orbit_start_.push_back(start);
            plan_.orbit_label_.push_back(label);
        }
    }

    /// The origin of h as its own face knows it.
    Index unmarked_origin(Index h) const { return mesh_.to(mesh_.prev(h)); }

    glm::vec3 cap_corner(Index h) const
    {
        const Index face = mesh_.face(h);
        const bool positive = face >= plan_.cap_face(Side::positive, 0);
        const CapTriangle& cap = s_.caps[face - plan_.cap_face(positive ? Side::positive : Side::negative, 0)];
        Index at = mesh_.halfedge_of_face(face);
        std::size_t corner = 0;
        while (at != h) {
            at = mesh_.next(at);
            ++corner;
        }
        static constexpr std::array<std::size_t, 3> kMirrored{0, 2, 1};
        return s_.loop_points[cap.corner[positive ? kMirrored[corner] : corner]];
    }

    Stitcher& plan_;
    SurfaceMesh& mesh_;
    CutScratch& s_;
};

void Stitcher::run(Universe& universe, CutScratch& scratch)
{
    StitchRun(*this, universe, scratch).run();
}

}  // namespace kerf::halfedge
