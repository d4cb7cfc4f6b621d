#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "common/mesh/indexed_mesh.h"

namespace kerf::core {

/// Mass properties of the solid that a closed mesh bounds, at density 1.
struct MassProperties
{
    double volume = 0.0;      ///< mesh units cubed; negative for a mesh that is inside out
    glm::dvec3 centre{0.0};   ///< centre of mass, in mesh coordinates; the reference point if the volume is 0
    glm::dmat3 inertia{0.0};  ///< inertia tensor about the centre of mass, mesh axes, mesh units to the fifth
};

/// Mass properties of a closed mesh, summed about mass_reference() of its bounds so that a mesh far from the origin
/// loses no digits. Exact up to rounding; for an open mesh the result depends on the reference point. All are 0 for an
/// empty mesh and for a mesh with an index out of range. O(n).
MassProperties mass_properties(const IndexedMesh& mesh);

}  // namespace kerf::core
