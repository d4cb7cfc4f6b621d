#include "viewer/sim/breaking/mesh_ray.h"

#include <glm/geometric.hpp>
#include <limits>
#include <new>

namespace kerf::sim {

std::optional<glm::dvec3> first_hit(const Object& object, const MeshRay& ray)
{
    DrawView view;
    if (!ok(object.draw(view))) throw std::bad_alloc();
    const auto position = [&](std::uint32_t index) {
        return glm::dvec3(glm::vec3(view.vertices[view.indices[index]].position));
    };
    double nearest = std::numeric_limits<double>::infinity();
    for (const DrawRange& range : view.ranges)
        for (std::uint32_t i = range.first_index; i + 3 <= range.first_index + range.index_count; i += 3) {
            const glm::dvec3 a = position(i), u = position(i + 1) - a, v = position(i + 2) - a;
            const glm::dvec3 p = glm::cross(ray.along, v);
            const double area = glm::dot(u, p);
            if (area == 0.0) continue;
            const glm::dvec3 to_ray = ray.from - a, q = glm::cross(to_ray, u);
            const double s = glm::dot(to_ray, p) / area, t = glm::dot(ray.along, q) / area;
            const double distance = glm::dot(v, q) / area;
            if (s >= 0.0 && t >= 0.0 && s + t <= 1.0 && distance >= 0.0 && distance < nearest) nearest = distance;
        }
    if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
    return ray.from + nearest * ray.along;
}

}  // namespace kerf::sim
