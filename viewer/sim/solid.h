#pragma once

#include <kerf/mass.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace kerf::sim {

/// Mass of a cubic metre, kg: wood. The motion does not depend on it, only what masses are shown.
inline constexpr double kDensity = 600.0;

/// A piece's mass, centre of mass and inertia in kilograms and metres.
struct Solid
{
    double mass = 0.0;          ///< kg
    glm::dvec3 centre{0.0};     ///< centre of mass, in mesh coordinates
    glm::dmat3 axes{1.0};       ///< columns: principal axes in mesh coordinates, right-handed
    glm::dvec3 moments{0.0};    ///< principal moments of inertia, kg m^2, ascending
    bool from_geometry = true;  ///< false: the mesh bounds no volume, and its box stands in

    /// Inertia tensor about the centre, mesh axes, kg m^2.
    glm::dmat3 inertia() const;
};

/// The solid that a closed mesh bounds, `scale` metres a mesh unit. Where the mesh bounds none (volume not positive,
/// centre outside the box: open or inverted meshes) a box of the same bounds, kHollowShare as heavy, stands in: a flat
/// piece still has a mass and an inertia. O(1).
Solid solid_of(const MassProperties& properties, const Box& bounds, double scale);

}  // namespace kerf::sim
