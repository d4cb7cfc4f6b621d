#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace kerf::core {

/// The axis along which a vector is longest: 0, 1 or 2. Dropping the dominant axis of a plane's normal projects the
/// plane without loss, and a ray along it leaves the plane fastest.
inline int dominant_axis(const glm::dvec3& v)
{
    const glm::dvec3 size = glm::abs(v);
    return size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
}

}  // namespace kerf::core
