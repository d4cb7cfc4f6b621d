#pragma once

#include <kerf/export.h>
#include <kerf/math.h>

namespace kerf {

/// @addtogroup physics
/// What a physics engine asks of a piece: mass, inertia, and simple shapes around it.
/// @{

/// Volume, centre of mass and inertia of a body of density 1, in the mesh's unit of length.
///
///     const kerf::MassProperties mass = piece.mass_properties();
///     const kerf::PrincipalAxes axes = kerf::principal_axes(mass.inertia_of(steel));
///     add_body(mass.mass(steel), mass.centre, axes.axes, axes.moments);
struct KERF_API MassProperties
{
    double volume = 0.0;  ///< in the unit, cubed
    Vec3d centre = {};    ///< of mass; of the bounds if there is no volume
    Mat3d inertia = {};   ///< about the centre, along the axes of the mesh
    /// Whether the surface is known to bound a solid: the mesh was closed, and so is each cut since. Otherwise these
    /// are sums over a surface that may bound nothing.
    bool is_of_solid = false;

    /// The mass of the same body of another density.
    double mass(double density) const noexcept { return volume * density; }
    /// And its inertia.
    Mat3d inertia_of(double density) const noexcept;

    /// The same of the body where the matrix places it: it may move, turn, scale, mirror and shear, by any matrix whose
    /// last row is 0, 0, 0, 1. Exact up to rounding. O(1).
    MassProperties placed(const Mat4d& object_to_world) const noexcept;
};

/// The axes about which a body turns without wobbling.
struct PrincipalAxes
{
    Vec3d moments = {};  ///< about the three axes, from small to large
    Mat3d axes = {};     ///< the columns; right-handed, each of length 1
};

/// By Jacobi's rotations (Golub and Van Loan, "Matrix Computations", section 8.5). O(1).
KERF_API PrincipalAxes principal_axes(const Mat3d& inertia) noexcept;

/// @}

}  // namespace kerf
