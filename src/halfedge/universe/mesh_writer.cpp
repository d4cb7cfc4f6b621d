#include "halfedge/universe/mesh_writer.h"

#include <algorithm>

namespace kerf::core::halfedge {

namespace {

/// How many vertices or triangles ahead that is read which another thread may have written: its cache gives a line away
/// in the time of some dozen triangles.
constexpr Index kNumberedAhead = 64;

}  // namespace

void MeshWriter::write(const NumberedChunk& chunk)
{
    u_.mesh.resize(chunk.points, chunk.edges, chunk.first + chunk.count);
    write_points(chunk.vertices);
    for (Index i = 0; i < chunk.count; ++i) {
        const SlotId slot(chunk.first + i);
        if (i + kNumberedAhead < chunk.count) {
            __builtin_prefetch(&halfedges_[slot.number() + kNumberedAhead]);
            __builtin_prefetch(&u_.slots[slot + kNumberedAhead]);
        }
        const FaceId face(static_cast<int>(slot.number()));
        const std::array<HalfedgeId, 3>& h = halfedges_[slot.number()];
        u_.mesh.set_triangle(face, h[0], h[1], h[2]);
        for (std::size_t c = 0; c < 3; ++c) {
            const PointId p = point(u_.slots[slot][c]);
            u_.mesh.set_to(h[(c + 2) % 3], p);
            u_.mesh.set_halfedge_of(p, h[c]);
        }
    }
}

void MeshWriter::write_points(Index vertices)
{
    for (; vertices_ < vertices; ++vertices_) {
        __builtin_prefetch(&u_.vertices[std::min(vertices_ + kNumberedAhead, vertices - 1)]);
        if (point_[vertices_] != points_) continue;
        u_.mesh.set_position(point(vertices_), u_.vertices[vertices_].position);
        ++points_;
    }
}

void MeshWriter::finish()
{
    SurfaceMesh& mesh = u_.mesh;
    mesh.touch_room();
    for (const HalfedgeId inside : numbering_.at_boundary()) {
        const HalfedgeId h = opposite(inside);
        mesh.set_to(h, mesh.to(mesh.prev(inside)));
        mesh.set_halfedge_of(mesh.to(inside), h);
    }
    for (const HalfedgeId inside : numbering_.at_boundary()) {
        const HalfedgeId h = opposite(inside);
        mesh.link(h, mesh.halfedge_of(mesh.to(h)));
    }
    for (std::size_t s = 0; s < mesh_.streams.size(); ++s) {
        const VertexStream& stream = mesh_.streams[s];
        float* values = u_.streams[s].values.data();
        for (const Index old_vertex : old_vertex_.first(vertices_))
            values = std::copy_n(&stream.values[std::size_t{old_vertex} * stream.width], stream.width, values);
    }
}

}  // namespace kerf::core::halfedge
