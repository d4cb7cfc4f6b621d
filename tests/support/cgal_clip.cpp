#include "support/cgal_clip.h"

#include <CGAL/Polygon_mesh_processing/clip.h>

#include <exception>

namespace kerf::core::test {

CgalMesh to_cgal(const IndexedMesh& mesh)
{
    CgalMesh result;
    std::vector<std::optional<CgalMesh::Vertex_index>> points(mesh.point_count);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const glm::dvec3 p(mesh.vertices[v].position);
        auto& point = points[mesh.points[v]];
        if (!point) point = result.add_vertex({p.x, p.y, p.z});
    }
    for (const Triangle& t : mesh.triangles)
        result.add_face(*points[mesh.points[t[0]]], *points[mesh.points[t[1]]], *points[mesh.points[t[2]]]);
    return result;
}

std::optional<CgalMesh> cgal_clipped(CgalMesh mesh, const Plane& plane)
{
    namespace PMP = CGAL::Polygon_mesh_processing;
    try {
        const bool is_done =
            PMP::clip(mesh, CgalKernel::Plane_3(plane.normal.x, plane.normal.y, plane.normal.z, -plane.offset),
                      CGAL::parameters::clip_volume(true));
        if (!is_done || !CGAL::is_closed(mesh)) return std::nullopt;
        return mesh;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

std::vector<NamedBackend> fast_backends()
{
    std::vector<NamedBackend> result;
    for (const NamedBackend& backend : backends())
        if (backend.name != "baseline_scan" && backend.name != "baseline_two_bucket_hash") result.push_back(backend);
    return result;
}

}  // namespace kerf::core::test
