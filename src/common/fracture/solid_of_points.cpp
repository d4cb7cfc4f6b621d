#include "common/fracture/solid_of_points.h"

namespace kerf::core {

SolidOfPoints::SolidOfPoints(const IndexedMesh& mesh) : points(mesh.point_count)
{
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) points[mesh.points[v]] = mesh.vertices[v].position;
    triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        triangles.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
}

}  // namespace kerf::core
