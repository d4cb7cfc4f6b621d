#pragma once

#include <cstdint>
#include <vector>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/tolerances.h"

namespace kerf::core {

/// Triangles as a file or a generator gives them: nothing is promised.
struct TriangleSoup
{
    Buffer<Vertex> vertices;
    Buffer<Triangle> triangles;
    std::vector<std::uint32_t> triangle_materials;  ///< one per triangle; empty: all 0
    std::vector<VertexStream> streams;
    std::vector<Material> materials;       ///< empty: one unnamed material
    bool has_normals = true;               ///< false: repair() computes smooth normals
    double crease_degrees = kCreaseAngle;  ///< edges that turn by more stay sharp then; 0 to 180
};

}  // namespace kerf::core
