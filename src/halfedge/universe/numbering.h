#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "common/repair/proven_mesh.h"
#include "halfedge/universe/ids.h"
#include "halfedge/universe/scratch_array.h"
#include "halfedge/universe/universe.h"

// The first of the two passes that write a mesh into a universe: what gets which number, and all that belongs to a
// triangle or a vertex alone. The second pass (mesh_writer.h) follows it chunk by chunk (numbered_chunks.h), on the same
// thread or on another one.

namespace kerf::core::halfedge {

/// Triangles that follow one another and have their numbers, so many that what is known of them stays in the cache.
struct NumberedChunk
{
    static constexpr std::size_t kTriangles = 2048;

    Index first = 0, count = 0;                 ///< triangles
    Index vertices = 0, points = 0, edges = 0;  ///< how many of them have a number once the chunk has
};

/// Numbers a mesh's triangles, one after another in their new order: vertices and points in the order of their first
/// use, edges in that of their first half-edge. A triangle tells its neighbours what half-edges they have in common, so
/// connectivity needs no search. Writes the slots and what runs parallel to them and to the vertices; the two passes
/// then have about the same work.
class Numbering
{
public:
    /// @param boundary  how many half-edges of the mesh have no opposite one
    Numbering(const ProvenMesh& proven, std::size_t boundary);

    /// The triangles of the mesh in their new order, and where they go; the arrays have their sizes. To be said before
    /// next().
    void begin(std::span<const Index> order, Universe& universe);

    std::size_t chunks() const { return (order_.size() + NumberedChunk::kTriangles - 1) / NumberedChunk::kTriangles; }
    /// Numbers the next chunk of triangles. Can't fail.
    NumberedChunk next();

    /// By triangle in the new order, as far as they have their numbers.
    std::span<const std::array<HalfedgeId, 3>> halfedges() const { return {halfedges_.data(), halfedges_.size()}; }
    /// By new vertex, as far as they have a number: the vertex of the mesh, and the point at which it lies.
    std::span<const Index> old_vertices() const { return {old_vertex_.data(), old_vertex_.size()}; }
    std::span<const Index> points() const { return {point_.data(), point_.size()}; }
    /// Half-edges whose opposite ones have no face. All of them once all triangles have their numbers.
    std::span<const HalfedgeId> at_boundary() const { return at_boundary_; }

private:
    void prefetch_triangle(Index old_triangle) const;
    void prefetch_neighbours(Index old_triangle) const;
    Index vertex(Index old_vertex);
    HalfedgeId halfedge(Index corner);
    void write_faces(const NumberedChunk& chunk);
    void write_vertices(Index first, Index end);

    const IndexedMesh& mesh_;
    std::span<const Index> opposite_;
    std::span<const Index> order_;
    Universe* u_ = nullptr;
    /// By half-edge of the mesh: its own number, once the triangle across has its numbers. Told by that triangle, so that
    /// each reads what lies together, and only writing goes all over the mesh. Invalid until then.
    ScratchArray<HalfedgeId> known_;
    // kNone: without a number yet.
    ScratchArray<Index> number_of_vertex_;               ///< by old vertex
    ScratchArray<Index> number_of_point_;                ///< by old point
    ScratchArray<Index> old_vertex_, point_;             ///< by new vertex
    ScratchArray<std::array<HalfedgeId, 3>> halfedges_;  ///< by new triangle
    std::vector<HalfedgeId> at_boundary_;
    /// Numbers handed out. They change all the time, so what another thread reads lies on other cache lines.
    struct alignas(64) Counts
    {
        Index triangles = 0, vertices = 0, points = 0, edges = 0;
    };
    Counts counts_;
};

}  // namespace kerf::core::halfedge
