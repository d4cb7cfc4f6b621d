#include "halfedge/cut/section.h"

#include <glm/geometric.hpp>

#include "common/caps/section_area.h"

namespace kerf::core::halfedge {

void Section::reserve(std::size_t crossings_expected)
{
    reserve_touched(cut_points, crossings_expected);
    reserve_touched(cut_point_is_shared, crossings_expected);
    reserve_touched(loop_edges, crossings_expected);
    reserve_touched(loop_points, crossings_expected);
}

void Section::clear()
{
    coincidences = {};
    cut_points.clear();
    boundary_cuts.clear();
    new_vertices = 0;
    clear_loops();
    loops_on_shell.clear();
    outline.clear();
    outline_points.clear();
    cancelled.clear();
    cut_point_is_shared.clear();
    any_shared = false;
}

double section_area(const Plane& plane, const Section& section)
{
    return core::section_area(plane, [&](auto visit) {
        for (const Loop& loop : section.loops) {
            if (!loop.closed) continue;
            const glm::vec3* p = &section.loop_points[loop.first];
            for (std::size_t i = 0; i < loop.count; ++i) visit(p[i], p[i + 1 < loop.count ? i + 1 : 0]);
        }
    });
}

double section_length(const Section& section)
{
    double length = 0.0;
    for (const Loop& loop : section.loops) {
        if (!loop.closed) continue;
        const glm::vec3* p = &section.loop_points[loop.first];
        for (std::size_t i = 0; i < loop.count; ++i)
            length += glm::distance(glm::dvec3(p[i]), glm::dvec3(p[i + 1 < loop.count ? i + 1 : 0]));
    }
    return length;
}

}  // namespace kerf::core::halfedge
