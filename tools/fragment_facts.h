#pragma once

#include <kerf/mass.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "tools/flat_mesh.h"
#include "tools/text.h"

namespace kerf::tools {

/// What is said about one fragment, or about all fragments of a side together.
struct FragmentFacts
{
    std::uint64_t triangles = 0;
    double surface_area = 0.0;  ///< of what was surface before the cut, mesh units squared
    double cap_area = 0.0;      ///< of the caps, each triangle counted positive
    double volume = 0.0;
    glm::dvec3 centre_of_mass{0.0};
    bool closed = true;  ///< each directed edge occurs as often as its reverse

    double area() const { return surface_area + cap_area; }

    /// Both together; the centre of mass is weighted by volume.
    void add(const FragmentFacts& other);
};

/// Measures a fragment's mesh; `mass` is what its back end says. O(n).
FragmentFacts measure_fragment(const FlatMesh& mesh, const MassProperties& mass);

Json facts_json(const FragmentFacts& facts);

/// "640 triangles, area 3.2, volume 0.9, closed"
std::string facts_text(const FragmentFacts& facts);

}  // namespace kerf::tools
