#pragma once

#include <LinearMath/btMatrix3x3.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

// Between Bullet's vectors (single precision) and GLM's.

namespace kerf::sim {

inline btVector3 to_bullet(const glm::dvec3& v)
{
    return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}

inline glm::dvec3 to_glm(const btVector3& v)
{
    return {double(v.x()), double(v.y()), double(v.z())};
}

/// GLM stores columns, Bullet rows.
inline btMatrix3x3 to_bullet(const glm::dmat3& m)
{
    return {btScalar(m[0][0]), btScalar(m[1][0]), btScalar(m[2][0]), btScalar(m[0][1]), btScalar(m[1][1]),
            btScalar(m[2][1]), btScalar(m[0][2]), btScalar(m[1][2]), btScalar(m[2][2])};
}

inline glm::dmat3 to_glm(const btMatrix3x3& m)
{
    glm::dmat3 out;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) out[column][row] = double(m[row][column]);
    return out;
}

}  // namespace kerf::sim
