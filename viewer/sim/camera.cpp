#include "viewer/sim/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace kerf::sim {

Camera::Camera(double aspect)
{
    if (!(std::isfinite(aspect) && aspect > 0.0)) aspect = kStageHalfWidth / kStageHalfHeight;
    const double half_height = std::max(kStageHalfHeight, kStageHalfWidth / aspect) / kEyeDistance * kNearPlane;
    view_ = glm::translate(glm::dmat4(1.0), -eye());
    projection_ =
        glm::frustum(-half_height * aspect, half_height * aspect, -half_height, half_height, kNearPlane, kFarPlane);
    inverse_ = glm::inverse(projection_ * view_);
}

glm::dvec2 Camera::screen_to_ndc(const glm::dvec2& pixel, const glm::dvec2& window_size)
{
    if (!(window_size.x > 0.0 && window_size.y > 0.0)) return glm::dvec2(0.0);
    return {2.0 * (pixel.x / window_size.x) - 1.0, -2.0 * (pixel.y / window_size.y) + 1.0};
}

glm::dvec2 Camera::ndc_to_screen(const glm::dvec2& ndc, const glm::dvec2& window_size)
{
    return {(ndc.x + 1.0) * 0.5 * window_size.x, (1.0 - ndc.y) * 0.5 * window_size.y};
}

glm::dvec3 Camera::ndc_to_world(const glm::dvec3& ndc) const
{
    const glm::dvec4 world = inverse_ * glm::dvec4(ndc, 1.0);
    return glm::dvec3(world) / world.w;
}

glm::dvec3 Camera::world_to_ndc(const glm::dvec3& world) const
{
    const glm::dvec4 clip = projection_ * (view_ * glm::dvec4(world, 1.0));
    return glm::dvec3(clip) / clip.w;
}

glm::dvec2 Camera::ndc_to_stage(const glm::dvec2& ndc) const
{
    const glm::dvec3 near = ndc_to_world({ndc, -1.0});
    const glm::dvec3 direction = near - eye();
    const double t = -eye().z / direction.z;
    return {eye().x + t * direction.x, eye().y + t * direction.y};
}

glm::dvec2 Camera::stage_to_screen(const glm::dvec2& stage, const glm::dvec2& window_size) const
{
    return ndc_to_screen(glm::dvec2(world_to_ndc({stage, 0.0})), window_size);
}

}  // namespace kerf::sim
