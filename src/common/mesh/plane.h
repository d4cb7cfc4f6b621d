#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "common/mesh/box.h"
#include "common/mesh/float_rules.h"

namespace kerf::core {

/// { p : dot(normal, p) = offset }. The positive side is where the normal points to, the plane itself included.
struct Plane
{
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit length
    double offset = 0.0;               ///< signed distance of the plane from the origin, in mesh units

    /// The plane through `point` with the direction of `normal`, which may have any length. Empty if a number is not
    /// finite or the normal has no direction.
    static std::optional<Plane> through(const glm::dvec3& point, const glm::dvec3& normal);

    /// Signed distance of a mesh vertex, in mesh units. The sign decides the side: >= 0 is positive, without a
    /// tolerance. The order of the additions is part of the contract: boxes are tested with the same expression.
    double signed_distance(const glm::vec3& p) const
    {
        return ((normal.x * double(p.x) + normal.y * double(p.y)) + normal.z * double(p.z)) - offset;
    }

    /// Smallest and largest signed distance that any vertex inside `box` can have, rounding included: multiplication
    /// and addition round monotonically, so the extreme corners bound every point between them bit for bit.
    std::array<double, 2> distance_range(const Box& box) const
    {
        const glm::vec3 near{normal.x >= 0 ? box.lo.x : box.hi.x, normal.y >= 0 ? box.lo.y : box.hi.y,
                             normal.z >= 0 ? box.lo.z : box.hi.z};
        const glm::vec3 far{normal.x >= 0 ? box.hi.x : box.lo.x, normal.y >= 0 ? box.hi.y : box.lo.y,
                            normal.z >= 0 ? box.hi.z : box.lo.z};
        return {signed_distance(near), signed_distance(far)};
    }

    /// The same plane seen from the other side. Points exactly on the plane change sides.
    Plane flipped() const { return {-normal, -offset}; }

    /// True if all four numbers are finite and the normal has unit length within rounding.
    bool valid() const;
};

}  // namespace kerf::core
