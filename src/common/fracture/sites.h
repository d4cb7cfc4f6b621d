#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/mesh/triangle_search.h"

namespace kerf::core {

/// How the cells of a fracture lie.
enum class FracturePattern : std::uint8_t
{
    uniform,    ///< anywhere in the solid
    impact,     ///< the nearer to a point, the smaller
    crack,      ///< the nearer to a plane, the smaller
    grid,       ///< in rows and layers, moved a little
    splinters,  ///< long, along a direction
};

struct SitesWanted
{
    FracturePattern pattern = FracturePattern::uniform;
    std::uint32_t count = 50;
    std::uint64_t seed = 0;
    glm::dvec3 at{0.0};                   ///< of an impact; on the plane of a crack; in the middle of splinters
    glm::dvec3 direction{0.0, 1.0, 0.0};  ///< across the plane of a crack, along splinters; of length 1
};

/// Sites of cells in the solid that a closed surface bounds, none twice. As many as wanted; of a grid about as many have a
/// part of the solid, and of a surface that has no inside there is none. No function of the system is called, and nothing
/// depends on the order of the triangles: the same sites on every machine, for every back end. O(n + m log m) for n
/// triangles that lines meet the boxes of, and m sites.
std::vector<glm::dvec3> make_sites(const TriangleSearch& triangles, const SitesWanted& wanted);

/// The same sites, each moved by at most `distance` along each axis. O(m).
std::vector<glm::dvec3> moved_a_little(std::span<const glm::dvec3> sites, double distance, std::uint64_t seed);

}  // namespace kerf::core
