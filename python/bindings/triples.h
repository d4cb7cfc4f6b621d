#pragma once

#include <kerf/math.h>

#include <array>

namespace kerf::python {

/// A point or a direction as Python gives it.
using Triple = std::array<double, 3>;

inline Vec3d vector(const Triple& t)
{
    return Vec3d(t[0], t[1], t[2]);
}

}  // namespace kerf::python
