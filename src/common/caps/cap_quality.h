#pragma once

#include <cstdint>

namespace kerf::core {

/// Which triangles close a section, the better ones last.
enum class CapQuality : std::uint8_t
{
    fast,      ///< the first way that can: cap_triangulator.h
    delaunay,  ///< a constrained Delaunay triangulation of the section's points; needs CGAL: has_constrained_ways()
};

}  // namespace kerf::core
