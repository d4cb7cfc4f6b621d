#pragma once

#include <span>

#include "halfedge/universe/numbering.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// The second pass that writes a mesh into a universe whose arrays have their sizes: points, faces and half-edges, chunk
/// after chunk of triangles that have their numbers, each chunk in the order of memory. The half-edge mesh grows
/// with them, within the room that it has: OpenMesh writes new elements, which are in the cache still when they get
/// their values.
class MeshWriter
{
public:
    MeshWriter(const IndexedMesh& mesh, const Numbering& numbering, Universe& universe)
        : mesh_(mesh),
          numbering_(numbering),
          halfedges_(numbering.halfedges()),
          old_vertex_(numbering.old_vertices()),
          point_(numbering.points()),
          u_(universe)
    {
    }

    /// Can't fail.
    void write(const NumberedChunk& chunk);
    /// Once all chunks are written: links the half-edges of the boundary, copies the streams, and touches the half-edge
    /// mesh's room.
    void finish();

private:
    void write_points(Index vertices);
    PointId point(Index vertex) const { return PointId(static_cast<int>(point_[vertex])); }

    const IndexedMesh& mesh_;
    const Numbering& numbering_;
    std::span<const std::array<HalfedgeId, 3>> halfedges_;
    std::span<const Index> old_vertex_, point_;
    Universe& u_;
    Index vertices_ = 0, points_ = 0;  ///< whose points are written, and those
};

}  // namespace kerf::core::halfedge
