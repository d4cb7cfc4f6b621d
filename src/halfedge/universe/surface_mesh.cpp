#include "halfedge/universe/surface_mesh.h"

#include <algorithm>
#include <new>

#include "halfedge/universe/huge_pages.h"

namespace kerf::halfedge {

namespace {

constexpr std::size_t kVertexBytes = 16, kEdgeBytes = 32, kFaceBytes = 4;

// Handles are signed 32-bit numbers, and there are two half-edges to an edge.
constexpr std::size_t kMost = std::size_t(1) << 30;

}  // namespace

SurfaceMesh::SurfaceMesh(const SurfaceMesh& other)
{
    reserve(other.room_.vertices, other.room_.edges, other.room_.faces);
    mesh_.assign_connectivity(other.mesh_);
    if (other.vertices() > 0)
        std::copy_n(other.mesh_.points(), other.vertices(), const_cast<decltype(mesh_)::Point*>(mesh_.points()));
}

void SurfaceMesh::reserve(std::size_t vertices, std::size_t edges, std::size_t faces)
{
    if (vertices > kMost || edges > kMost || faces > kMost) throw std::bad_alloc();
    const Sizes wanted{std::max(vertices, room_.vertices), std::max(edges, room_.edges), std::max(faces, room_.faces)};
    const std::size_t v = mesh_.n_vertices(), e = mesh_.n_edges(), f = mesh_.n_faces();
    if (wanted.vertices > asked_.vertices || wanted.edges > asked_.edges || wanted.faces > asked_.faces) {
        ask_for(wanted);
        // OpenMesh tells no address but that of an element, so one edge must exist.
        mesh_.resize(v, std::max<std::size_t>(e, 1), f);
        prefer_huge_pages(&mesh_.edge(OpenMesh::EdgeHandle(0)), wanted.edges * kEdgeBytes);
    }
    mesh_.resize(wanted.vertices, wanted.edges, wanted.faces);
    mesh_.resize(v, e, f);
    room_ = wanted;
}

void SurfaceMesh::ask_for(const Sizes& wanted)
{
    const auto more = [](std::size_t count) { return std::min(kMost, 2 * count); };
    const Sizes ample{more(wanted.vertices), more(wanted.edges), more(wanted.faces)};
    try {
        mesh_.reserve(ample.vertices, ample.edges, ample.faces);
        asked_ = ample;
    } catch (const std::bad_alloc&) {
        mesh_.reserve(wanted.vertices, wanted.edges, wanted.faces);
        asked_ = wanted;
    }
}

std::size_t SurfaceMesh::make_room(std::size_t vertices, std::size_t edges, std::size_t faces)
{
    const std::size_t v = mesh_.n_vertices() + vertices, e = mesh_.n_edges() + edges, f = mesh_.n_faces() + faces;
    if (v <= room_.vertices && e <= room_.edges && f <= room_.faces) return 0;
    const std::size_t before = bytes_reserved();
    reserve(v, e, f);
    return bytes_reserved() - before;
}

std::size_t SurfaceMesh::bytes_reserved() const
{
    return room_.vertices * kVertexBytes + room_.edges * kEdgeBytes + room_.faces * kFaceBytes;
}

}  // namespace kerf::halfedge
