#include "viewer/sim/solid.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "viewer/sim/kerf_glm.h"

namespace kerf::sim {
namespace {

/// Share of a box's mass that a mesh without volume gets.
constexpr double kHollowShare = 0.1;
/// Sides of that box are at least this, metres.
constexpr double kThinnestBox = 1e-3;
/// A volume below this share of the box's counts as none: an eighth-digit error of a closed mesh is no solid.
constexpr double kLeastVolumeShare = 1e-7;
/// No principal moment is below this share of the largest: a needle can't be spun up without bound by rounding.
constexpr double kLeastMomentShare = 1e-6;
/// A centre of mass may lie so far outside the box, in units in the last place of its largest coordinate.
constexpr double kCentreSlack = 4.0;

Solid box_solid(const Box& bounds, double scale)
{
    Solid solid;
    solid.from_geometry = false;
    const glm::dvec3 extent = bounds.is_empty() ? glm::dvec3(0.0) : extent_of(bounds);
    const glm::dvec3 side = glm::max(extent * scale, glm::dvec3(kThinnestBox));
    solid.mass = kHollowShare * kDensity * side.x * side.y * side.z;
    solid.centre = bounds.is_empty() ? glm::dvec3(0.0) : centre_of(bounds);
    const glm::dvec3 squares = side * side;
    const glm::dvec3 moments =
        solid.mass / 12.0 * glm::dvec3(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
    solid.moments = moments;
    return solid;
}

/// The centre of mass of a sliver may lie outside its box by the rounding of its vertices.
bool about_inside(const glm::dvec3& p, const Box& box)
{
    const float largest = largest_coordinate(box);
    const double slack = kCentreSlack * (double(largest) - double(std::nextafter(largest, 0.0f)));
    const glm::dvec3 lo(glm::vec3(box.lo)), hi(glm::vec3(box.hi));
    for (int axis = 0; axis < 3; ++axis)
        if (!(p[axis] >= lo[axis] - slack && p[axis] <= hi[axis] + slack)) return false;
    return true;
}

}  // namespace

glm::dmat3 Solid::inertia() const
{
    glm::dmat3 diagonal(0.0);
    for (int i = 0; i < 3; ++i) diagonal[i][i] = moments[i];
    return axes * diagonal * glm::transpose(axes);
}

Solid solid_of(const MassProperties& properties, const Box& bounds, double scale)
{
    if (bounds.is_empty()) return box_solid(bounds, scale);
    const glm::dvec3 side = extent_of(bounds);
    const double least = kLeastVolumeShare * side.x * side.y * side.z;
    if (!(properties.volume > least) || !about_inside(glm::dvec3(properties.centre), bounds))
        return box_solid(bounds, scale);

    Solid solid;
    solid.mass = kDensity * properties.volume * scale * scale * scale;
    solid.centre = glm::dvec3(properties.centre);

    Eigen::Matrix3d tensor;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) tensor(row, column) = properties.inertia.m[column][row];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
    if (solver.info() != Eigen::Success) return box_solid(bounds, scale);
    const double to_si = kDensity * scale * scale * scale * scale * scale;
    for (int axis = 0; axis < 3; ++axis) {
        solid.moments[axis] = solver.eigenvalues()(axis) * to_si;
        for (int row = 0; row < 3; ++row) solid.axes[axis][row] = solver.eigenvectors()(row, axis);
    }
    if (glm::determinant(solid.axes) < 0.0) solid.axes[2] = -solid.axes[2];
    if (!(solid.moments.z > 0.0) || !std::isfinite(solid.moments.z)) return box_solid(bounds, scale);
    solid.moments = glm::max(solid.moments, glm::dvec3(kLeastMomentShare * solid.moments.z));
    return solid;
}

}  // namespace kerf::sim
