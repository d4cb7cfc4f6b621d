#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

// Sections as lines: what is common to all formats.

namespace kerf::core::drawings {

/// A line of a drawing: a loop or a chain.
struct DrawnPath
{
    std::vector<glm::dvec2> places;  ///< in the plane, mesh units; x to the right, y upwards
    std::vector<glm::vec3> points;   ///< the same in space
    bool is_closed = true;
    bool is_hole = false;
    std::uint32_t shape = 0;  ///< loops that are filled together have the same: an outer loop and its holes
};

/// A section.
struct DrawnLayer
{
    double height = 0.0;  ///< of its plane above the origin, along the normal, mesh units
    std::vector<DrawnPath> paths;
};

struct Drawing
{
    std::vector<DrawnLayer> layers;
    double millimetres = 1.0;  ///< in one unit of the mesh
    std::string unit = "mm";   ///< what that unit is called
};

}  // namespace kerf::core::drawings
