#pragma once

#include <cstdint>
#include <span>

#include "common/mesh/triangle_soup.h"
#include "common/repair/linked_surface.h"
#include "common/repair/vertex_fans.h"

namespace kerf::core {

/// What the vertices of a repaired mesh are made from. Triangles of the surface are numbered as in `surface`.
struct VertexSources
{
    const TriangleSoup& soup;
    std::span<const std::uint32_t> first_equal;     ///< for each soup vertex the first one with the same attributes
    std::span<const std::uint32_t> soup_triangles;  ///< for each triangle of the surface the one in the soup
    const LinkedSurface& surface;
    const VertexFans& fans;
    std::span<const glm::vec3> positions;  ///< of the surface's points
};

/// Fills vertices, points, triangles and streams of `mesh`, with triangles in the given order and vertices and points
/// numbered by first use: one vertex for each fan and different attributes in it. Without normals in the soup, smooth
/// ones are computed and creases get vertices of their own. Given normals of triangles that were turned over are
/// turned if they point behind them. The soup is clean (clean_soup.h). O(n).
void build_vertices(const VertexSources& sources, std::span<const std::uint32_t> order, IndexedMesh& mesh);

}  // namespace kerf::core
