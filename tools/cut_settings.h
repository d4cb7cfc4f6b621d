#pragma once

#include <kerf/cut.h>

#include <glm/vec3.hpp>
#include <optional>

namespace kerf::tools {

/// Where and how `kerf cut` cuts: what the command line says, or a line of a file of jobs.
struct CutSettings
{
    std::optional<Plane> plane;        ///< this, or a normal
    std::optional<glm::dvec3> point;   ///< default: centre of the bounds
    std::optional<glm::dvec3> normal;  ///< of any length but 0
    bool cap = true;
    bool components = false;
    double gap = 0.0;
    std::optional<OnlyNear> only;
    CapQuality cap_quality = CapQuality::fast;

    bool has_plane() const { return plane || normal; }
    /// In a mesh with these bounds. @throws std::runtime_error
    Plane plane_in(const Box& bounds) const;
    CutOptions options() const;
};

}  // namespace kerf::tools
