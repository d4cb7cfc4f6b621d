#include "viewer/sim/cap_area.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <new>

namespace kerf::sim {
namespace {

/// Areas that differ by less are equal, as a share of the areas they are made of: corners are floats, and a corner that
/// moves by its last place, 6e-8 of the object's size, moves the area of a thin section by some hundred times that.
constexpr double kAreaRounding = 1e-4;

}  // namespace

double cap_area(const Object& object)
{
    DrawView view;
    if (!ok(object.draw(view))) throw std::bad_alloc();
    double twice = 0.0;
    for (const DrawRange& range : view.ranges) {
        if (range.kind != TriangleKind::cap) continue;
        for (std::size_t i = range.first_index; i + 3 <= std::size_t{range.first_index} + range.index_count; i += 3) {
            const auto corner = [&](std::size_t c) {
                return glm::dvec3(glm::vec3(view.vertices[view.indices[i + c]].position));
            };
            const glm::dvec3 a = corner(0);
            twice += glm::length(glm::cross(corner(1) - a, corner(2) - a));
        }
    }
    return 0.5 * twice;
}

bool is_closed_rightly(double area_before, double area_after, double section)
{
    // Both sides close the section.
    const double wanted = area_before + 2.0 * section;
    return std::abs(area_after - wanted) <= kAreaRounding * wanted;
}

}  // namespace kerf::sim
