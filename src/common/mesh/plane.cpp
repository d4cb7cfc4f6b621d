#include "common/mesh/plane.h"

#include <cmath>

#include "common/mesh/tolerances.h"

namespace kerf::core {

std::optional<Plane> Plane::through(const glm::dvec3& point, const glm::dvec3& normal)
{
    // Unlike a plain sum of squares, hypot neither overflows nor underflows on its way.
    glm::dvec3 direction = normal;
    double length = std::hypot(direction.x, direction.y, direction.z);
    if (std::isinf(length)) {  // the length of the largest normals is no double; that of their halves is
        direction *= 0.5;
        length = std::hypot(direction.x, direction.y, direction.z);
    }
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    Plane plane{direction / length, 0.0};
    plane.offset = (plane.normal.x * point.x + plane.normal.y * point.y) + plane.normal.z * point.z;
    if (!plane.valid()) return std::nullopt;
    return plane;
}

bool Plane::valid() const
{
    const double length = std::hypot(normal.x, normal.y, normal.z);
    return std::isfinite(length) && std::isfinite(offset) && std::abs(length - 1.0) <= kUnitTolerance;
}

}  // namespace kerf::core
