#include "halfedge/universe/surface_mesh.h"

#include <algorithm>
#include <new>

#include "halfedge/universe/huge_pages.h"

namespace kerf::core::halfedge {

namespace {

constexpr std::size_t kPointBytes = 16, kEdgeBytes = 32, kFaceBytes = 4;

// Handles are signed 32-bit numbers, and there are two half-edges to an edge.
constexpr std::size_t kMost = std::size_t(1) << 30;

}  // namespace

SurfaceMesh::SurfaceMesh(const SurfaceMesh& other)
{
    grow(other.room_, other.sizes());
    mesh_.assign_connectivity(other.mesh_);
    if (other.points() > 0)
        std::copy_n(other.mesh_.points(), other.points(), const_cast<decltype(mesh_)::Point*>(mesh_.points()));
}

void SurfaceMesh::start(const Sizes& room)
{
    if (room.points > kMost || room.edges > kMost || room.faces > kMost) throw std::bad_alloc();
    ask_for(room);
    started_ = room;
}

void SurfaceMesh::grow(const Sizes& room, const Sizes& then)
{
    if (room.points > kMost || room.edges > kMost || room.faces > kMost) throw std::bad_alloc();
    const Sizes wanted{std::max(room.points, room_.points), std::max(room.edges, room_.edges),
                       std::max(room.faces, room_.faces)};
    if (wanted.points > asked_.points || wanted.edges > asked_.edges || wanted.faces > asked_.faces) ask_for(wanted);
    mesh_.resize(wanted.points, wanted.edges, wanted.faces);
    // New positions are all that OpenMesh does not write to.
    const std::size_t touched = std::max(room_.points, then.points);
    for (std::size_t i = touched; i < wanted.points; ++i) set_position(PointId(static_cast<int>(i)), glm::vec3(0.0f));
    mesh_.resize(then.points, then.edges, then.faces);
    room_ = wanted;
}

void SurfaceMesh::ask_for(const Sizes& wanted)
{
    // OpenMesh's arrays are ordinary ones, which are copied when they have no room left: tens of milliseconds in one cut
    // of a large mesh. What is not touched costs addresses only. glibc keeps what is up to 32 MB for the next object, so
    // that room is as much as stays below.
    constexpr std::size_t kKept = std::size_t(1) << 25, kRoomIfNotKept = 8;
    std::size_t room = kRoomIfNotKept;
    for (const std::size_t kept_room : {4, 16})
        if (kept_room * wanted.edges * kEdgeBytes < kKept) room = kept_room;
    const auto more = [&](std::size_t count) { return std::min(kMost, room * count); };
    const Sizes ample{more(wanted.points), more(wanted.edges), more(wanted.faces)};
    try {
        mesh_.reserve(ample.points, ample.edges, ample.faces);
        asked_ = ample;
    } catch (const std::bad_alloc&) {
        mesh_.reserve(wanted.points, wanted.edges, wanted.faces);
        asked_ = wanted;
    }
    // OpenMesh tells no address but that of an element, so one of each must exist.
    const std::size_t v = points(), e = edges(), f = faces();
    mesh_.resize(std::max<std::size_t>(v, 1), std::max<std::size_t>(e, 1), std::max<std::size_t>(f, 1));
    // What a long chain of cuts adds comes in small pages: memory_block.cpp says why.
    const auto prefer = [](auto& first, std::size_t count) { prefer_huge_pages(&first, count * sizeof(first)); };
    prefer(mesh_.edge(EdgeId(0)), wanted.edges);
    prefer(mesh_.face(FaceId(0)), wanted.faces);
    prefer(mesh_.vertex(PointId(0)), wanted.points);
    prefer(mesh_.point(PointId(0)), wanted.points);
    mesh_.resize(v, e, f);
}

std::size_t SurfaceMesh::make_room(std::size_t points, std::size_t edges, std::size_t faces)
{
    const std::size_t v = mesh_.n_vertices() + points, e = mesh_.n_edges() + edges, f = mesh_.n_faces() + faces;
    if (v <= room_.points && e <= room_.edges && f <= room_.faces) return 0;
    const std::size_t before = bytes_reserved();
    grow({v, e, f}, sizes());
    return bytes_reserved() - before;
}

std::size_t SurfaceMesh::bytes_reserved() const
{
    return room_.points * kPointBytes + room_.edges * kEdgeBytes + room_.faces * kFaceBytes;
}

}  // namespace kerf::core::halfedge
