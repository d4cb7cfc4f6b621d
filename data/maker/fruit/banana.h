#pragma once

#include <glm/vec3.hpp>

#include "maker/fruit/growth.h"

namespace kerf::maker {

inline constexpr int kBananaSegments = 40;

/// Where on the banana's axis, an arc in the plane z = 0, and how it runs there.
struct BananaAxis
{
    glm::dvec3 place;
    glm::dvec3 along;    ///< unit, towards the stalk
    glm::dvec3 inwards;  ///< unit, towards the arc's centre; the third direction is +z
};

/// @param share  of the way along the axis, -1 (the flower's end) to 1 (the stalk)
BananaAxis banana_axis(double share);

/// A banana's skin from the flower's end to a share of the way along its axis, open at both ends. Points turn from
/// inwards towards +z.
SkinRings grow_banana(Lathe& lathe, double to_share);
void close_flowers_end(Lathe& lathe, const Ring& lowest);

}  // namespace kerf::maker
