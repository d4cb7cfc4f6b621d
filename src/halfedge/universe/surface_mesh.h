#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdint>
#include <glm/vec3.hpp>

#include "common/mesh/index.h"

// The half-edge mesh behind the back end: OpenMesh for connectivity and positions, nothing else. Indices are plain
// 32-bit numbers outside this file, because the rest of the universe is arrays that run parallel to OpenMesh's.

namespace kerf::halfedge {

struct SurfaceTraits : OpenMesh::DefaultTraits
{
    // No status, no normals, no colours: attributes belong to corners and lie in arrays of our own.
    VertexAttributes(0);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(0);
    FaceAttributes(0);
};

/// OpenMesh with index types. The opposite of half-edge h is h ^ 1. A half-edge without a face lies on the boundary.
class SurfaceMesh
{
public:
    Index opposite(Index h) const { return h ^ 1u; }
    Index next(Index h) const { return index(mesh_.next_halfedge_handle(halfedge(h))); }
    Index prev(Index h) const { return index(mesh_.prev_halfedge_handle(halfedge(h))); }
    Index to(Index h) const { return index(mesh_.to_vertex_handle(halfedge(h))); }
    Index from(Index h) const { return to(h ^ 1u); }
    Index face(Index h) const { return index(mesh_.face_handle(halfedge(h))); }
    Index halfedge_of_face(Index f) const { return index(mesh_.halfedge_handle(OpenMesh::FaceHandle(int(f)))); }
    Index halfedge_of_vertex(Index v) const { return index(mesh_.halfedge_handle(OpenMesh::VertexHandle(int(v)))); }
    bool is_boundary(Index h) const { return face(h) == kNone; }
    glm::vec3 point(Index v) const
    {
        const auto& p = mesh_.point(OpenMesh::VertexHandle(int(v)));
        return {p[0], p[1], p[2]};
    }

    void prefetch_face(Index f) const { __builtin_prefetch(&mesh_.face(OpenMesh::FaceHandle(int(f)))); }
    void prefetch_halfedge(Index h) const { __builtin_prefetch(&mesh_.edge(OpenMesh::EdgeHandle(int(h >> 1)))); }

    void link(Index h, Index next) { mesh_.set_next_halfedge_handle(halfedge(h), halfedge(next)); }
    void set_to(Index h, Index v) { mesh_.set_vertex_handle(halfedge(h), OpenMesh::VertexHandle(int(v))); }
    void set_face(Index h, Index f) { mesh_.set_face_handle(halfedge(h), OpenMesh::FaceHandle(int(f))); }
    void set_halfedge_of_face(Index f, Index h)
    {
        mesh_.set_halfedge_handle(OpenMesh::FaceHandle(int(f)), halfedge(h));
    }
    void set_halfedge_of_vertex(Index v, Index h)
    {
        mesh_.set_halfedge_handle(OpenMesh::VertexHandle(int(v)), halfedge(h));
    }
    void set_point(Index v, const glm::vec3& p) { mesh_.set_point(OpenMesh::VertexHandle(int(v)), {p.x, p.y, p.z}); }

    /// Makes face f of three half-edges in order; the first one is that of corner 0.
    void set_triangle(Index f, Index a, Index b, Index c)
    {
        link(a, b);
        link(b, c);
        link(c, a);
        set_face(a, f);
        set_face(b, f);
        set_face(c, f);
        set_halfedge_of_face(f, a);
    }

    std::size_t vertices() const { return mesh_.n_vertices(); }
    std::size_t edges() const { return mesh_.n_edges(); }
    std::size_t faces() const { return mesh_.n_faces(); }

    /// Sets the sizes. Within reserved room it cannot fail and costs O(added elements).
    void resize(std::size_t vertices, std::size_t edges, std::size_t faces) { mesh_.resize(vertices, edges, faces); }

    /// Makes room for so many elements in all and touches it. As in AppendBuffer, memory for as much again is asked for
    /// but not touched. Throws std::bad_alloc.
    void reserve(std::size_t vertices, std::size_t edges, std::size_t faces);

    /// Makes room for more elements; returns the bytes by which the arrays grew. O(added elements), unless the memory
    /// that was asked for is used up.
    std::size_t make_room(std::size_t vertices, std::size_t edges, std::size_t faces);

    std::size_t bytes_reserved() const;

    SurfaceMesh() = default;
    SurfaceMesh(const SurfaceMesh& other);
    SurfaceMesh& operator=(const SurfaceMesh&) = delete;
    SurfaceMesh(SurfaceMesh&&) = default;
    SurfaceMesh& operator=(SurfaceMesh&&) = default;

private:
    static OpenMesh::HalfedgeHandle halfedge(Index h) { return OpenMesh::HalfedgeHandle(int(h)); }
    static Index index(const OpenMesh::BaseHandle& handle) { return Index(handle.idx()); }

    struct Sizes
    {
        std::size_t vertices = 0, edges = 0, faces = 0;
    };
    void ask_for(const Sizes& wanted);

    OpenMesh::TriMesh_ArrayKernelT<SurfaceTraits> mesh_;
    Sizes room_, asked_;  ///< touched, and asked for: OpenMesh does not tell its capacities
};

/// Visits the half-edges that leave the origin of `start`, each once, by rotating around it. Stops at a boundary in
/// both directions. `visit(h)` gets half-edges that have a face, and the one boundary half-edge that leaves, if any.
template <class Visit>
void for_each_outgoing(const SurfaceMesh& mesh, Index start, Visit visit)
{
    Index h = start;
    if (!mesh.is_boundary(h)) {
        do {
            visit(h);
            h = mesh.prev(h) ^ 1u;
        } while (h != start && !mesh.is_boundary(h));
        if (h == start) return;
        visit(h);
    } else {
        visit(h);
    }
    // The other way round: from the opposite of `start` onwards.
    h = start ^ 1u;
    while (!mesh.is_boundary(h)) {
        h = mesh.next(h);
        visit(h);
        h ^= 1u;
    }
}

}  // namespace kerf::halfedge
