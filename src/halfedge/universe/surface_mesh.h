#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdint>
#include <glm/vec3.hpp>

#include "common/cutting/progress.h"
#include "halfedge/universe/ids.h"

// The half-edge mesh behind the back end: OpenMesh for connectivity and positions, nothing else. What else is known of
// faces lies in arrays of the universe that run parallel to OpenMesh's.

namespace kerf::core::halfedge {

struct SurfaceTraits : OpenMesh::DefaultTraits
{
    // No status, no normals, no colours: attributes belong to corners and lie in arrays of our own.
    VertexAttributes(0);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(0);
    FaceAttributes(0);
};

/// OpenMesh, as far as it is needed. A half-edge without a face lies on the boundary.
class SurfaceMesh
{
public:
    HalfedgeId next(HalfedgeId h) const { return mesh_.next_halfedge_handle(h); }
    HalfedgeId prev(HalfedgeId h) const { return mesh_.prev_halfedge_handle(h); }
    PointId to(HalfedgeId h) const { return mesh_.to_vertex_handle(h); }
    PointId from(HalfedgeId h) const { return to(opposite(h)); }
    FaceId face(HalfedgeId h) const { return mesh_.face_handle(h); }
    HalfedgeId halfedge_of(FaceId f) const { return mesh_.halfedge_handle(f); }
    HalfedgeId halfedge_of(PointId p) const { return mesh_.halfedge_handle(p); }
    bool is_boundary(HalfedgeId h) const { return !face(h).is_valid(); }
    glm::vec3 position(PointId point) const
    {
        const auto& p = mesh_.point(point);
        return {p[0], p[1], p[2]};
    }

    void prefetch(PointId p) const { __builtin_prefetch(&mesh_.vertex(p)); }
    void prefetch(FaceId f) const { __builtin_prefetch(&mesh_.face(f)); }
    void prefetch(HalfedgeId h) const { __builtin_prefetch(&mesh_.edge(edge_of(h))); }

    void link(HalfedgeId h, HalfedgeId next) { mesh_.set_next_halfedge_handle(h, next); }
    void set_to(HalfedgeId h, PointId p) { mesh_.set_vertex_handle(h, p); }
    void set_face(HalfedgeId h, FaceId f) { mesh_.set_face_handle(h, f); }
    void set_halfedge_of(FaceId f, HalfedgeId h) { mesh_.set_halfedge_handle(f, h); }
    void set_halfedge_of(PointId p, HalfedgeId h) { mesh_.set_halfedge_handle(p, h); }
    void set_position(PointId point, const glm::vec3& p) { mesh_.set_point(point, {p.x, p.y, p.z}); }

    /// Makes face f of three half-edges in order; the first one is that of corner 0.
    void set_triangle(FaceId f, HalfedgeId a, HalfedgeId b, HalfedgeId c)
    {
        link(a, b);
        link(b, c);
        link(c, a);
        set_face(a, f);
        set_face(b, f);
        set_face(c, f);
        set_halfedge_of(f, a);
    }

    std::size_t points() const { return mesh_.n_vertices(); }
    std::size_t edges() const { return mesh_.n_edges(); }
    std::size_t faces() const { return mesh_.n_faces(); }

    /// Sets the sizes. Within reserved room it cannot fail and costs O(added elements).
    void resize(std::size_t points, std::size_t edges, std::size_t faces) { mesh_.resize(points, edges, faces); }

    struct Sizes
    {
        std::size_t points = 0, edges = 0, faces = 0;
    };

    /// Asks for room for so many elements in all, of an empty mesh, but does not touch it: the caller is about to resize it
    /// step by step. As in AppendBuffer, memory for more is asked for, too. Throws std::bad_alloc.
    void start(const Sizes& room);
    /// Touches what was asked for and is no element yet, so that a cut need not.
    void touch_room() { grow(started_, sizes()); }

    /// Makes room for more elements; returns the bytes by which the arrays grew. O(added elements), unless the memory
    /// that was asked for is used up.
    std::size_t make_room(std::size_t points, std::size_t edges, std::size_t faces);

    std::size_t bytes_reserved() const;

    SurfaceMesh() = default;
    SurfaceMesh(const SurfaceMesh& other);
    SurfaceMesh& operator=(const SurfaceMesh&) = delete;
    SurfaceMesh(SurfaceMesh&&) = default;
    SurfaceMesh& operator=(SurfaceMesh&&) = default;

private:
    Sizes sizes() const { return {points(), edges(), faces()}; }
    /// Makes room and touches it; the mesh has the sizes `then` afterwards.
    void grow(const Sizes& room, const Sizes& then);
    void ask_for(const Sizes& wanted);

    OpenMesh::TriMesh_ArrayKernelT<SurfaceTraits> mesh_;
    Sizes room_, asked_;  ///< touched, and asked for: OpenMesh does not tell its capacities
    Sizes started_;       ///< what start() was asked for
};

/// Visits the half-edges that leave the origin of `start`, each once, by rotating around it. Stops at a boundary in
/// both directions. `visit(h)` gets half-edges that have a face, and the one boundary half-edge that leaves, if any.
template <class Visit>
void for_each_outgoing(const SurfaceMesh& mesh, HalfedgeId start, Visit visit)
{
    HalfedgeId h = start;
    if (!mesh.is_boundary(h)) {
        do {
            visit(h);
            h = opposite(mesh.prev(h));
        } while (h != start && !mesh.is_boundary(h));
        if (h == start) return;
        visit(h);
    } else {
        visit(h);
    }
    // The other way round: from the opposite of `start` onwards.
    h = opposite(start);
    while (!mesh.is_boundary(h)) {
        h = mesh.next(h);
        visit(h);
        h = opposite(h);
    }
}

}  // namespace kerf::core::halfedge
