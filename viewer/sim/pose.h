#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace kerf::sim {

/// Where a mesh stands in the world: world = scale * rotation * p + translation. The mesh's own coordinates never
/// change, so the pivot of a piece is part of this.
struct MeshPose
{
    double scale = 1.0;  ///< metres a mesh unit
    glm::dmat3 rotation{1.0};
    glm::dvec3 translation{0.0};  ///< metres

    glm::dvec3 to_world(const glm::dvec3& p) const { return scale * (rotation * p) + translation; }
    glm::dmat4 matrix() const
    {
        glm::dmat4 m(scale * rotation);
        m[3] = glm::dvec4(translation, 1.0);
        return m;
    }
};

/// How a rigid body moves.
struct Motion
{
    glm::dvec3 velocity{0.0};  ///< of the centre of mass, m/s
    glm::dvec3 spin{0.0};      ///< angular velocity in world axes, rad/s
};

}  // namespace kerf::sim
