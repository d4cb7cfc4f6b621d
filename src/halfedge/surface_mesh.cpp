#include "halfedge/surface_mesh.h"

#include <algorithm>
#include <new>

#include "halfedge/huge_pages.h"

namespace kerf::halfedge {

namespace {

constexpr std::size_t kVertexBytes = 16, kEdgeBytes = 32, kFaceBytes = 4;

}  // namespace

SurfaceMesh::SurfaceMesh(const SurfaceMesh& other)
{
    reserve(other.vertex_room_, other.edge_room_, other.face_room_);
    mesh_.assign_connectivity(other.mesh_);
    if (other.vertices() > 0)
        std::copy_n(other.mesh_.points(), other.vertices(), const_cast<decltype(mesh_)::Point*>(mesh_.points()));
}

void SurfaceMesh::reserve(std::size_t vertices, std::size_t edges, std::size_t faces)
{
    // Handles are signed 32-bit numbers, and there are two half-edges to an edge.
    constexpr std::size_t kMost = std::size_t(1) << 30;
    if (vertices > kMost || edges > kMost || faces > kMost) throw std::bad_alloc();
    const std::size_t v = mesh_.n_vertices(), e = mesh_.n_edges(), f = mesh_.n_faces();
    vertices = std::max(vertices, vertex_room_);
    edges = std::max(edges, edge_room_);
    faces = std::max(faces, face_room_);
    mesh_.reserve(vertices, edges, faces);
    if (edges > edge_room_) {
        // An address inside the block is all that OpenMesh gives away.
        mesh_.resize(v, std::max<std::size_t>(e, 1), f);
        prefer_huge_pages(&mesh_.edge(OpenMesh::EdgeHandle(0)), edges * kEdgeBytes);
    }
    mesh_.resize(vertices, edges, faces);
    mesh_.resize(v, e, f);
    vertex_room_ = vertices;
    edge_room_ = edges;
    face_room_ = faces;
}

std::size_t SurfaceMesh::make_room(std::size_t vertices, std::size_t edges, std::size_t faces)
{
    const std::size_t v = mesh_.n_vertices() + vertices, e = mesh_.n_edges() + edges, f = mesh_.n_faces() + faces;
    if (v <= vertex_room_ && e <= edge_room_ && f <= face_room_) return 0;
    const std::size_t before = bytes_reserved();
    const auto grown = [](std::size_t needed, std::size_t room) {
        return needed <= room ? room : std::max(needed, room + room / 2);
    };
    reserve(grown(v, vertex_room_), grown(e, edge_room_), grown(f, face_room_));
    return bytes_reserved() - before;
}

std::size_t SurfaceMesh::bytes_reserved() const
{
    return vertex_room_ * kVertexBytes + edge_room_ * kEdgeBytes + face_room_ * kFaceBytes;
}

}  // namespace kerf::halfedge
