#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/geometry/point_tree.h"
#include "common/geometry/ray_crossing.h"

namespace kerf::core {

/// Rays of one direction, tested against triangles and boxes one at a time. Building costs O(r log r) for r rays; a
/// triangle costs a search for the rays through its bounds.
class ParallelRays
{
public:
    explicit ParallelRays(std::span<const AxisRay> rays) : rays_(rays), origins_(origins_of(rays)), tree_(origins_) {}

    /// Whether a ray may meet the box; if false, none does.
    bool may_meet(const Box& box) const { return !rays_.empty() && tree_.any_in(reach(box)); }

    /// Calls visit(ray, term) for each ray whose ray_crossing() with the triangle, `term`, is not 0.
    template <class Visit>
    void for_each_crossing(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, Visit&& visit) const
    {
        if (rays_.empty()) return;
        Box box;
        for (const glm::vec3& p : {a, b, c}) box.add(p);
        tree_.for_each_in(reach(box), [&](std::uint32_t ray) {
            if (const int term = ray_crossing(rays_[ray], a, b, c); term != 0) visit(ray, term);
        });
    }

private:
    /// The box that holds the origins of all rays that meet the given one.
    Box reach(Box box) const
    {
        const AxisRay& ray = rays_.front();
        if (ray.ascending)
            box.lo[ray.axis] = -std::numeric_limits<float>::infinity();
        else
            box.hi[ray.axis] = std::numeric_limits<float>::infinity();
        return box;
    }

    static std::vector<glm::vec3> origins_of(std::span<const AxisRay> rays)
    {
        std::vector<glm::vec3> origins;
        origins.reserve(rays.size());
        for (const AxisRay& ray : rays) origins.push_back(ray.origin);
        return origins;
    }

    std::span<const AxisRay> rays_;
    std::vector<glm::vec3> origins_;
    PointTree tree_;
};

}  // namespace kerf::core
