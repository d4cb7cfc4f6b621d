#include "halfedge/cut/split.h"

#include "halfedge/cut/crossing_numbers.h"

namespace kerf::core::halfedge {

namespace {

/// Notes what is special about a triangle whose cut points coincide with corners or with each other.
void note_coincidences(const Universe& u, const Crossing& c, Coincidences& noted)
{
    noted.irregular = true;
    for (const auto& [code, own] : {std::pair{c.split.next_code, TriangleSplit::kCutNext},
                                    std::pair{c.split.previous_code, TriangleSplit::kCutPrevious}}) {
        if (code == own) continue;
        if (code >= 3 || c.distance[code] != 0.0) noted.collapsed = true;
        if (code < 3 && u.mesh.is_boundary(u.mesh.halfedge_of(c.point[code]))) noted.meets_boundary = true;
    }
}

template <class Numbers>
Index crossing_beyond(const Universe& u, const Numbers& numbers, HalfedgeId halfedge)
{
    const FaceId face = u.mesh.face(opposite(halfedge));
    return face.is_valid() ? numbers.of(face) : kNone;
}

}  // namespace

template <class Numbers>
Coincidences split_crossings(const Universe& u, const Numbers& numbers, Found& found)
{
    Coincidences noted;
    // What a triangle leads to is asked for some triangles ahead: its face, number and vertices, then its half-edges.
    constexpr std::size_t kAhead = 8;
    const std::size_t count = found.crossings.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i + 2 * kAhead < count) {
            u.mesh.prefetch(found.crossings[i + 2 * kAhead].face);
            numbers.prefetch(found.crossings[i + 2 * kAhead].face);
            for (const VertexId v : found.crossings[i + 2 * kAhead].corner) __builtin_prefetch(&u.vertex(v));
        }
        if (i + kAhead < count) u.mesh.prefetch(u.mesh.halfedge_of(found.crossings[i + kAhead].face));
        if (i + kAhead / 2 < count) {
            const HalfedgeId h = u.mesh.halfedge_of(found.crossings[i + kAhead / 2].face);
            u.mesh.prefetch(u.mesh.next(h));
            u.mesh.prefetch(u.mesh.prev(h));
        }
        Crossing& c = found.crossings[i];
        c.split = split_triangle(
            {u.vertex(c.corner[0]).position, u.vertex(c.corner[1]).position, u.vertex(c.corner[2]).position},
            c.distance);
        c.walked = false;
        c.entry_cut_point = c.exit_cut_point = CutPointId();
        c.entry_vertex = c.exit_vertex = VertexId();
        HalfedgeId h = u.mesh.halfedge_of(c.face);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            c.halfedge[corner] = h;
            c.point[(corner + 1) % 3] = u.mesh.to(h);
            h = u.mesh.next(h);
        }
        // Here the numbers of neighbours come one independent of the other; WALK would wait for each.
        c.beyond_n = crossing_beyond(u, numbers, c.halfedge[static_cast<std::size_t>(c.lone())]);
        c.beyond_p = crossing_beyond(u, numbers, c.halfedge[static_cast<std::size_t>(c.previous())]);
        if (c.split.next_code != TriangleSplit::kCutNext || c.split.previous_code != TriangleSplit::kCutPrevious)
            note_coincidences(u, c, noted);
    }
    if (!found.in_plane.empty()) noted.irregular = true;
    for (const InPlaneEdge& e : found.in_plane)
        for (const HalfedgeId h : {e.negative_halfedge, e.positive_halfedge})
            if (u.mesh.is_boundary(u.mesh.halfedge_of(u.mesh.to(h)))) noted.meets_boundary = true;
    return noted;
}

template Coincidences split_crossings(const Universe&, const FaceStamps&, Found&);
template Coincidences split_crossings(const Universe&, const FaceTable&, Found&);

}  // namespace kerf::core::halfedge
