#include "common/mesh/mass_properties.h"

#include "common/mesh/mass_moments.h"

namespace kerf::core {

MassProperties mass_properties(const IndexedMesh& mesh)
{
    if (!are_in_range(mesh.triangles, mesh.vertices.size())) return {};
    const glm::dvec3 reference = mass_reference(mesh.bounds());
    return mass_moments(mesh.vertices, mesh.triangles, reference).properties(reference);
}

}  // namespace kerf::core
