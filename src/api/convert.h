#pragma once

#include <kerf/mass.h>
#include <kerf/mesh.h>
#include <kerf/plane.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "common/cutting/cut.h"
#include "common/mesh/box.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"
#include "common/mesh/side.h"

// Between the public types and those of the library's own code.

namespace kerf {

static_assert(int(Status::done) == int(core::Status::done) && int(Status::missed) == int(core::Status::missed) &&
              int(Status::open_section) == int(core::Status::open_section) &&
              int(Status::invalid_argument) == int(core::Status::invalid_argument) &&
              int(Status::invalid_mesh) == int(core::Status::invalid_mesh) &&
              int(Status::out_of_memory) == int(core::Status::out_of_memory) &&
              int(Status::cancelled) == int(core::Status::cancelled) &&
              int(Status::not_separated) == int(core::Status::not_separated));
static_assert(sizeof(Vec3f) == sizeof(glm::vec3));

inline glm::dvec3 to_core(const Vec3d& v)
{
    return {v.x, v.y, v.z};
}
inline core::Plane to_core(const Plane& plane)
{
    return {to_core(plane.normal()), plane.offset()};
}
inline core::Side to_core(Side side)
{
    return side == Side::positive ? core::Side::positive : core::Side::negative;
}

inline Vec3f to_public(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}
inline Vec3d to_public(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}
inline Mat3d to_public(const glm::dmat3& m)
{
    Mat3d result;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) result.m[column][row] = m[column][row];
    return result;
}
inline MassProperties to_public(const core::MassProperties& from)
{
    MassProperties to;
    to.volume = from.volume;
    to.centre = to_public(from.centre);
    to.inertia = to_public(from.inertia);
    return to;
}
inline Material to_public(const core::Material& material)
{
    Material result;
    result.name = material.name.c_str();
    for (int c = 0; c < 4; ++c) result.base_colour[c] = material.colour[c];
    result.base_colour_image = material.texture.c_str();
    return result;
}
inline core::Material to_core(const Material& material)
{
    core::Material result;
    result.name = material.name != nullptr ? material.name : "";
    for (int c = 0; c < 4; ++c)
        result.colour[c] = std::isfinite(material.base_colour[c]) ? material.base_colour[c] : 1.0f;
    result.texture = material.base_colour_image != nullptr ? material.base_colour_image : "";
    return result;
}
inline Status to_public(core::Status status)
{
    return static_cast<Status>(status);
}
inline Side to_public(core::Side side)
{
    return side == core::Side::positive ? Side::positive : Side::negative;
}
inline Box to_public(const core::Box& box)
{
    if (box.empty()) return {};
    return {to_public(box.lo), to_public(box.hi)};
}

}  // namespace kerf
