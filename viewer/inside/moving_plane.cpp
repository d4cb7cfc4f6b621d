#include "viewer/inside/moving_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace kerf::inside {

namespace {

constexpr double kYaw = 0.7, kPitch = 0.3;
/// Close to straight up, where yaw would mean nothing.
constexpr double kMostPitch = 1.5;

glm::dvec3 to_glm(const Vec3f& v)
{
    return {v.x, v.y, v.z};
}

}  // namespace

MovingPlane::MovingPlane(const Box& bounds) : yaw_(kYaw), pitch_(kPitch)
{
    middle_ = 0.5 * (to_glm(bounds.lo) + to_glm(bounds.hi));
    half_diagonal_ = 0.5 * glm::distance(to_glm(bounds.lo), to_glm(bounds.hi));
}

void MovingPlane::move(double way)
{
    set_place(place_ + way);
}

void MovingPlane::set_place(double place)
{
    place_ = std::clamp(place, -1.0, 1.0);
}

void MovingPlane::turn(const glm::dvec2& angles)
{
    yaw_ += angles.x;
    pitch_ = std::clamp(pitch_ + angles.y, -kMostPitch, kMostPitch);
}

void MovingPlane::flip()
{
    is_flipped_ = !is_flipped_;
    place_ = -place_;
}

glm::dvec3 MovingPlane::normal() const
{
    const glm::dvec3 n(std::cos(pitch_) * std::sin(yaw_), std::sin(pitch_), std::cos(pitch_) * std::cos(yaw_));
    return is_flipped_ ? -n : n;
}

Plane MovingPlane::plane() const
{
    const glm::dvec3 n = normal();
    return Plane::at(Point(middle_ + place_ * half_diagonal_ * n), Normal(n)).value_or(*Plane::z(0.0));
}

}  // namespace kerf::inside
