#include <kerf/object.h>

#include "baseline/report_back_ends.h"
#include "baseline/report_proxy/every_vertex.h"

namespace kerf {

std::vector<Vec3f> report_collision_points(const Object& object)
{
    std::vector<Vec3f> points;
    if (object.is_empty()) return points;
    for (const glm::vec3& p : core::baseline::every_vertex(*object.inside()).points) points.emplace_back(p.x, p.y, p.z);
    return points;
}

}  // namespace kerf
