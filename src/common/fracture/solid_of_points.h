#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "common/fracture/divided_surface.h"
#include "common/mesh/indexed_mesh.h"

namespace kerf::core {

/// A mesh by its points alone.
struct SolidOfPoints
{
    std::vector<glm::vec3> points;
    std::vector<PointTriple> triangles;

    explicit SolidOfPoints(const IndexedMesh& mesh);
};

}  // namespace kerf::core
