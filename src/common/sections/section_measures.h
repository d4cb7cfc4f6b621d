#pragma once

#include <glm/vec3.hpp>

#include "common/cutting/plane_section.h"
#include "common/mesh/box.h"
#include "common/mesh/plane.h"

// Lengths, areas and centres of what a plane meets; the same bits in whatever order a back end finds the edges.

namespace kerf::core {

/// Of a whole section.
struct SectionMeasures
{
    double area = 0.0;    ///< section_area() of the closed loops, bit for bit; mesh units squared
    double length = 0.0;  ///< of all loops and chains, mesh units
    /// Centroid of what the loops enclose, in the plane up to rounding. If they enclose nothing, or if loops that wind
    /// backwards leave it outside of the section's box: that of the outline. The origin of a section without points.
    glm::dvec3 centroid{0.0};
    Box box;  ///< of all points
};

/// Measures a section, and fills PlaneSection::Path::area and ::length. O(k) for k edges.
SectionMeasures measure_section(const Plane& plane, PlaneSection& section);

}  // namespace kerf::core
