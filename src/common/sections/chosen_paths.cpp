#include "common/sections/chosen_paths.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <span>

#include "common/mesh/position_order.h"
#include "common/sections/loop_nesting.h"
#include "common/sections/section_measures.h"

namespace kerf::core {

namespace {

/// The square of a point's distance from the nearest place of an edge.
double squared_distance(const glm::dvec3& point, const glm::vec3& p, const glm::vec3& q)
{
    const glm::dvec3 along = glm::dvec3(q) - glm::dvec3(p), to_point = point - glm::dvec3(p);
    const double length = glm::dot(along, along);
    const double t = length > 0.0 ? std::clamp(glm::dot(to_point, along) / length, 0.0, 1.0) : 0.0;
    const glm::dvec3 apart = to_point - t * along;
    return glm::dot(apart, apart);
}

std::size_t nearest_path(const PlaneSection& section, const glm::dvec3& point)
{
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    glm::vec3 first{};
    for (std::size_t i = 0; i < section.paths.size(); ++i) {
        const PlaneSection::Path& path = section.paths[i];
        double distance = std::numeric_limits<double>::infinity();
        section.for_each_edge(path, [&](std::size_t, const glm::vec3& p, const glm::vec3& q) {
            // Neighbours run along a loop the other way round: both must say the same.
            distance = std::min(
                distance, lexicographically_less(q, p) ? squared_distance(point, q, p) : squared_distance(point, p, q));
        });
        const glm::vec3 least_point = *std::ranges::min_element(
            section.points_of(path),
            [](const glm::vec3& a, const glm::vec3& b) { return lexicographically_less(a, b); });
        if (distance < least || (distance == least && lexicographically_less(least_point, first))) {
            nearest = i;
            least = distance;
            first = least_point;
        }
    }
    return nearest;
}

}  // namespace

std::vector<bool> choose_paths(const Plane& plane, const OnlyNear& only, PlaneSection& section)
{
    std::vector<bool> is_chosen(section.paths.size(), false);
    if (section.paths.empty()) return is_chosen;
    std::size_t chosen = nearest_path(section, only.point);
    const std::uint32_t solid = section.paths[chosen].solid;
    if (only.extent == OnlyNear::Extent::solid) {
        for (std::size_t i = 0; i < section.paths.size(); ++i) is_chosen[i] = section.paths[i].solid == solid;
        return is_chosen;
    }
    measure_section(plane, section);
    LoopNesting nesting;
    const std::span<const std::uint32_t> parents = nesting.find(plane, section);
    const auto is_hole = [&](std::size_t i) { return section.paths[i].closed && section.paths[i].area < 0.0; };
    // Of a hole the loop around it, past loops of other solids that lie between.
    std::size_t outer = chosen;
    while (is_hole(outer) || section.paths[outer].solid != solid) {
        if (parents[outer] == kNoContainer) break;
        outer = parents[outer];
    }
    if (!is_hole(outer) && section.paths[outer].solid == solid) chosen = outer;
    is_chosen[chosen] = true;
    for (std::size_t i = 0; i < section.paths.size(); ++i) {
        if (!is_hole(i) || section.paths[i].solid != solid) continue;
        std::size_t around = parents[i];
        while (around != kNoContainer && section.paths[around].solid != solid) around = parents[around];
        if (around == chosen) is_chosen[i] = true;
    }
    return is_chosen;
}

}  // namespace kerf::core
