#include "halfedge/handover/sewing.h"

#include <algorithm>

namespace kerf::core::halfedge {

Sewing::Sewing(const Universe& universe, const Border& border, std::span<const PieceBorder> pieces)
    : u_(universe), pieces_(pieces)
{
    Place next{u_.mesh.points(), u_.vertices.size(), u_.mesh.edges(), u_.mesh.faces(), 0};
    for (const PieceBorder& piece : pieces) {
        places_.push_back(next);
        first_vertex_.push_back(vertices_.size());
        first_point_.push_back(points_.size());
        for (const std::uint32_t old : piece.old_vertex)
            vertices_.push_back(old == kNone ? static_cast<Index>(next.vertex++) : border.old_vertices()[old]);
        for (const std::uint32_t old : piece.old_point)
            points_.push_back(old == kNone ? PointId(int(next.point++)) : border.old_points()[old]);
        for (std::size_t h = 0; h < piece.opposite.size(); ++h) {
            const std::uint32_t other = piece.opposite[h];
            if (other == kNone)
                halfedges_.push_back(taken_over(border, piece, h));
            else if (other > h)
                halfedges_.push_back(first_halfedge(EdgeId(int(next.edge++))));
            else
                halfedges_.push_back(opposite(halfedges_[next.halfedge + other]));
        }
        next.face += piece.mesh.triangles.size();
        next.halfedge += piece.opposite.size();
    }
    places_.push_back(next);
}

/// The side of the divided triangle that begins where a half-edge of its part does.
HalfedgeId Sewing::taken_over(const Border& border, const PieceBorder& piece, std::size_t halfedge) const
{
    const std::uint32_t start = piece.mesh.points[piece.mesh.triangles[halfedge / 3][halfedge % 3]];
    const PointId point = border.old_points()[piece.old_point[start]];
    HalfedgeId h = u_.mesh.halfedge_of(u_.face_of_slot[border.slots()[piece.divided[halfedge / 3]]]);
    while (u_.mesh.from(h) != point) h = u_.mesh.next(h);
    return h;
}

void Sewing::make_room(Universe& u) const
{
    const Place &begin = places_.front(), &end = places_.back();
    u.mesh.make_room(end.point - begin.point, end.edge - begin.edge, end.face - begin.face);
    u.vertices.make_room(end.vertex - begin.vertex);
    for (Stream& stream : u.streams) stream.values.make_room((end.vertex - begin.vertex) * stream.width);
    u.source_of_face.make_room(end.face - begin.face);
    u.stamp_of_face.make_room(end.face - begin.face);
}

void Sewing::run(Universe& u) const
{
    u.mesh.resize(places_.back().point, places_.back().edge, places_.back().face);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        add_vertices(u, p);
        sew(u, p);
    }
}

void Sewing::add_vertices(Universe& u, std::size_t p) const
{
    const PieceBorder& piece = pieces_[p];
    for (std::size_t v = 0; v < piece.old_vertex.size(); ++v) {
        if (piece.old_vertex[v] != kNone) continue;
        u.vertices.push(piece.mesh.vertices[v]);
        for (std::size_t s = 0; s < u.streams.size(); ++s) {
            const std::size_t width = u.streams[s].width;
            for (std::size_t i = 0; i < width; ++i)
                u.streams[s].values.push(piece.mesh.streams[s].values[v * width + i]);
        }
    }
}

void Sewing::sew(Universe& u, std::size_t p) const
{
    const IndexedMesh& mesh = pieces_[p].mesh;
    const HalfedgeId* const halfedges = &halfedges_[places_[p].halfedge];
    const PointId* const points = &points_[first_point_[p]];
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (pieces_[p].old_point[mesh.points[v]] == kNone)
            u.mesh.set_position(points[mesh.points[v]], mesh.vertices[v].position);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const HalfedgeId* const h = halfedges + 3 * t;
        u.mesh.set_triangle(face(p, t), h[0], h[1], h[2]);
        for (std::size_t c = 0; c < 3; ++c) {
            const PointId point = points[mesh.points[mesh.triangles[t][c]]];
            u.mesh.set_to(h[(c + 2) % 3], point);
            u.mesh.set_halfedge_of(point, h[c]);
        }
        u.source_of_face.push(mesh.sources[t]);
        u.stamp_of_face.push(0);
    }
}

Triangle Sewing::triangle(std::size_t p, std::size_t t) const
{
    Triangle corners = pieces_[p].mesh.triangles[t];
    for (Index& v : corners) v = vertices_[first_vertex_[p] + v];
    return corners;
}

}  // namespace kerf::core::halfedge
