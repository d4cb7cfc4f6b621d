#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "maker/fruit/shape.h"
#include "maker/lathe.h"
#include "maker/poly_mesh.h"

namespace kerf::maker {

/// A fruit's skin from pole to pole, upwards: rings at polar angles from near pi down to near 0.
/// @param polars  descending, radians
struct SkinRings
{
    Ring lowest, highest;
};
SkinRings grow_skin(PolyMesh& mesh, Lathe& lathe, int segments, Outline outline, const std::vector<double>& polars);

/// Angles from `from` to `to` in `bands` even steps.
std::vector<double> even_angles(double from, double to, int bands);

/// A place on a stalk's axis.
struct Station
{
    glm::dvec3 centre;
    double radius;
};

/// Grows a round tube from `from` through the stations. Rings stay square to the axis. Returns the last ring.
Ring grow_tube(Lathe& lathe, int segments, const Ring& from, const std::vector<Station>& stations);

/// A place on a leaf's midrib.
struct LeafStation
{
    glm::dvec3 centre;
    glm::dvec3 up;       ///< unit, out of the leaf's upper face
    double half_width;   ///< of the blade
    double half_height;  ///< half the thickness at the midrib
    double fold;         ///< how far the edges stand above the midrib
};

/// Grows a leaf out of two neighbouring quads, segments `i` and `i` + 1 of a band that was left out there. Its faces
/// have four smoothing groups from `smoothing` on.
void grow_leaf(PolyMesh& mesh, const Ring& lower, const Ring& upper, int i, const std::vector<LeafStation>& stations,
               const glm::dvec3& tip, std::string_view material, int smoothing);

/// Adds a copy of `source` that is inside out: the skin of a cavity.
void add_cavity(PolyMesh& mesh, const PolyMesh& source);

}  // namespace kerf::maker
