#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kerf::sim {

/// What all scenes show: the part of the plane z = 0 that a 16:9 window sees. It belongs to the world, not to the
/// window, so that a run gives the same answer at any window size. Metres.
inline constexpr double kStageHalfHeight = 4.0;
inline constexpr double kStageHalfWidth = kStageHalfHeight * 16.0 / 9.0;
/// The eye's distance from that plane: a vertical field of view of 2 atan(4 / 10) = 43.6 degrees.
inline constexpr double kEyeDistance = 10.0;
inline constexpr double kNearPlane = 0.5, kFarPlane = 60.0;

/// A look along -z from (0, 0, kEyeDistance) at the plane z = 0 in which objects fly, in the terms of the report's
/// section 3.1. A window wider than 16:9 sees more at its sides; in a narrower one the angle of view grows so that the
/// stage's width still fits. The eye stays where it is: cutting planes go through it.
class Camera
{
public:
    /// @param aspect  width / height of the window; not finite or not positive: 16:9
    explicit Camera(double aspect = kStageHalfWidth / kStageHalfHeight);

    static glm::dvec3 eye() { return {0.0, 0.0, kEyeDistance}; }
    const glm::dmat4& view() const { return view_; }
    /// OpenGL's clip space: depth from -1 to 1.
    const glm::dmat4& projection() const { return projection_; }

    /// Pixels, from the upper left corner, to normalised device coordinates: x = 2 mx / width - 1,
    /// y = -2 my / height + 1. A window without area gives the centre.
    static glm::dvec2 screen_to_ndc(const glm::dvec2& pixel, const glm::dvec2& window_size);
    static glm::dvec2 ndc_to_screen(const glm::dvec2& ndc, const glm::dvec2& window_size);

    /// Normalised device coordinates, depth included, to world space: by the inverse of projection * view.
    glm::dvec3 ndc_to_world(const glm::dvec3& ndc) const;
    glm::dvec3 world_to_ndc(const glm::dvec3& world) const;

    /// Where the ray from the eye through a point of the window meets the plane z = 0: what pointer input is given in.
    glm::dvec2 ndc_to_stage(const glm::dvec2& ndc) const;
    glm::dvec2 screen_to_stage(const glm::dvec2& pixel, const glm::dvec2& window_size) const
    {
        return ndc_to_stage(screen_to_ndc(pixel, window_size));
    }
    /// Where the eye sees a place of the world, which is in front of it, on the plane z = 0.
    static glm::dvec2 seen_on_stage(const glm::dvec3& world)
    {
        return glm::dvec2(world) * kEyeDistance / (kEyeDistance - world.z);
    }
    glm::dvec2 stage_to_screen(const glm::dvec2& stage, const glm::dvec2& window_size) const;

private:
    glm::dmat4 view_, projection_, inverse_;
};

}  // namespace kerf::sim
