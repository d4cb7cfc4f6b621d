#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/fracture/divided_surface.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/triangle_search.h"

namespace kerf::core {

/// A mesh by its points alone.
struct SolidOfPoints
{
    std::vector<glm::vec3> points;
    std::vector<PointTriple> triangles;

    explicit SolidOfPoints(const IndexedMesh& mesh);
    /// With room for so many points: numbers behind those that the mesh has belong to none yet.
    SolidOfPoints(const IndexedMesh& mesh, std::size_t point_count);
    /// Takes over what was appended to the mesh. O(added).
    void add_rest(const IndexedMesh& mesh);

private:
    std::size_t vertices_ = 0;  ///< of the mesh, so far
};

/// All triangles of a solid, one after the other.
class AllTriangles final : public TriangleSearch
{
public:
    /// The solid stays meanwhile.
    explicit AllTriangles(const SolidOfPoints& solid) : solid_(solid) {}

    Box bounds() const override;
    void find(const std::function<bool(const Box&)>& is_wanted,
              const std::function<void(std::span<const Corners>)>& visit) const override;

private:
    const SolidOfPoints& solid_;
};

}  // namespace kerf::core
