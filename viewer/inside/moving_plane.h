#pragma once

#include <kerf/math.h>
#include <kerf/plane.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kerf::inside {

/// A plane that a user moves through a model, in the model's own coordinates. Its positive side is what is taken away.
class MovingPlane
{
public:
    /// Through the middle of the bounds, with its positive side towards the eye and a little to the right and upwards.
    explicit MovingPlane(const Box& bounds);

    /// Along the normal, in half diagonals of the bounds. It stays where it may meet the model.
    void move(double way);
    void set_place(double place);
    /// About the middle of the bounds: to the right and upwards, radians. Not beyond straight up or down.
    void turn(const glm::dvec2& angles);
    /// Exchanges the sides.
    void flip();

    Plane plane() const;
    glm::dvec3 normal() const;
    /// From the middle of the bounds along the normal, in half diagonals: from -1 to 1.
    double place() const { return place_; }
    glm::dvec3 middle() const { return middle_; }
    double half_diagonal() const { return half_diagonal_; }

private:
    glm::dvec3 middle_{0.0};
    double half_diagonal_ = 1.0;
    double yaw_, pitch_;  ///< of the normal: from z to x, and upwards
    double place_ = 0.0;
    bool is_flipped_ = false;
};

}  // namespace kerf::inside
