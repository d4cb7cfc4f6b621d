#include "viewer/sim/parting.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "viewer/sim/point_inertia.h"

namespace kerf::sim {
namespace {

/// One side of the plane: all its pieces as the one rigid body that they are at this moment.
struct SideBody
{
    double mass = 0.0;
    glm::dvec3 centre{0.0};
    glm::dmat3 inertia{0.0};
    Motion motion;
};

SideBody gather(std::span<const Part> parts, bool positive)
{
    SideBody side;
    for (const Part& part : parts) {
        if (part.positive != positive) continue;
        side.mass += part.mass;
        side.centre += part.mass * part.centre;
    }
    if (!(side.mass > 0.0)) return side;
    side.centre /= side.mass;
    for (const Part& part : parts)
        if (part.positive == positive)
            side.inertia += part.inertia + part.mass * point_inertia(part.centre - side.centre);
    return side;
}

/// Spin that a unit impulse along `direction` at `point` gives; zero where the inertia can't be inverted.
glm::dvec3 spin_of_impulse(const SideBody& side, const glm::dvec3& point, const glm::dvec3& direction)
{
    const glm::dvec3 spin = glm::inverse(side.inertia) * glm::cross(point - side.centre, direction);
    return std::isfinite(spin.x) && std::isfinite(spin.y) && std::isfinite(spin.z) ? spin : glm::dvec3(0.0);
}

void kick_apart(SideBody& positive, SideBody& negative, const glm::dvec3& normal, const glm::dvec3& on_plane,
                double speed)
{
    const double above = glm::dot(positive.centre - on_plane, normal);
    const double below = glm::dot(negative.centre - on_plane, normal);
    const double span = above - below;
    const double t = span > 0.0 ? glm::clamp(above / span, 0.0, 1.0) : 0.5;
    const glm::dvec3 common = glm::mix(positive.centre, negative.centre, t);

    const glm::dvec3 positive_spin = spin_of_impulse(positive, common, normal);
    const glm::dvec3 negative_spin = spin_of_impulse(negative, common, normal);
    double impulse = speed * positive.mass * negative.mass / (positive.mass + negative.mass);
    const double fastest = impulse * std::max(glm::length(positive_spin), glm::length(negative_spin));
    if (fastest > kFastestKickSpin) impulse *= kFastestKickSpin / fastest;

    positive.motion.velocity += impulse / positive.mass * normal;
    positive.motion.spin += impulse * positive_spin;
    negative.motion.velocity -= impulse / negative.mass * normal;
    negative.motion.spin -= impulse * negative_spin;
}

}  // namespace

void part_ways(const glm::dvec3& centre, const Motion& motion, const glm::dvec3& normal, const glm::dvec3& on_plane,
               std::span<Part> parts, double parting_speed)
{
    SideBody sides[2] = {gather(parts, false), gather(parts, true)};
    for (SideBody& side : sides) {
        side.motion.spin = motion.spin;
        side.motion.velocity = motion.velocity + glm::cross(motion.spin, side.centre - centre);
    }
    if (sides[0].mass > 0.0 && sides[1].mass > 0.0) kick_apart(sides[1], sides[0], normal, on_plane, parting_speed);

    for (Part& part : parts) {
        const SideBody& side = sides[part.positive ? 1 : 0];
        part.motion.spin = side.motion.spin;
        part.motion.velocity = side.motion.velocity + glm::cross(side.motion.spin, part.centre - side.centre);
    }
}

}  // namespace kerf::sim
