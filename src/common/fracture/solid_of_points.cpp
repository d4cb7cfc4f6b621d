#include "common/fracture/solid_of_points.h"

#include <algorithm>
#include <array>

namespace kerf::core {

SolidOfPoints::SolidOfPoints(const IndexedMesh& mesh) : SolidOfPoints(mesh, mesh.point_count) {}

SolidOfPoints::SolidOfPoints(const IndexedMesh& mesh, std::size_t point_count) : points(point_count)
{
    triangles.reserve(mesh.triangles.size());
    add_rest(mesh);
}

void SolidOfPoints::add_rest(const IndexedMesh& mesh)
{
    for (; vertices_ < mesh.vertices.size(); ++vertices_)
        points[mesh.points[vertices_]] = mesh.vertices[vertices_].position;
    for (std::size_t t = triangles.size(); t < mesh.triangles.size(); ++t) {
        const Triangle& corners = mesh.triangles[t];
        triangles.push_back({mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]});
    }
}

Box AllTriangles::bounds() const
{
    Box box;
    for (const glm::vec3& p : solid_.points) box.add(p);
    return box;
}

void AllTriangles::find(const std::function<bool(const Box&)>& /*is_wanted*/,
                        const std::function<void(std::span<const Corners>)>& visit) const
{
    constexpr std::size_t kAtOnce = 256;
    std::array<Corners, kAtOnce> some;
    for (std::size_t first = 0; first < solid_.triangles.size(); first += kAtOnce) {
        const std::size_t count = std::min(kAtOnce, solid_.triangles.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const PointTriple& t = solid_.triangles[first + i];
            some[i] = {solid_.points[t[0]], solid_.points[t[1]], solid_.points[t[2]]};
        }
        visit(std::span(some).first(count));
    }
}

}  // namespace kerf::core
