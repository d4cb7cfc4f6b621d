#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "common/mesh/float_range.h"
#include "common/mesh/float_rules.h"

namespace kerf::core {

/// Two unit vectors that span a plane: cross(u, v) = normal. Cap uv are coordinates along them, so they are fixed to
/// the object. The same normal always gives the same frame.
struct PlaneFrame
{
    glm::dvec3 u, v;
    double uv_scale = 1.0;  ///< uv for each mesh unit

    static PlaneFrame of(const glm::dvec3& normal, double uv_scale = 1.0);

    /// The frame in which `up` points upwards: v is the part of it that lies in the plane. If it has none, but for what
    /// rounding leaves, the frame is that of the normal alone.
    static PlaneFrame upright(const glm::dvec3& normal, const glm::dvec3& up);

    /// The planar uv of a cap's vertex: its coordinates along both vectors, times `uv_scale`. In a box of the largest
    /// floats a coordinate along a diagonal can exceed the largest float; it then becomes the largest.
    glm::vec2 uv(const glm::vec3& p) const
    {
        return {nearest_finite_float(uv_scale * glm::dot(u, glm::dvec3(p))),
                nearest_finite_float(uv_scale * glm::dot(v, glm::dvec3(p)))};
    }
};

}  // namespace kerf::core
