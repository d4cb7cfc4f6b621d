#pragma once

#include <kerf/cut.h>
#include <kerf/math.h>

#include <glm/vec3.hpp>
#include <stdexcept>
#include <utility>

// The library's values as benchmarks use them.

namespace kerf::bench {

inline glm::dvec3 to_glm(const Vec3d& v)
{
    return {v.x, v.y, v.z};
}

inline glm::dvec3 centre_of(const Box& box)
{
    return 0.5 * (to_glm(box.lo) + to_glm(box.hi));
}

/// @throws std::runtime_error  there is none; with the library's sentence
template <class T>
T value_of(Result<T> result)
{
    if (!result) throw std::runtime_error(result.reason());
    return *std::move(result);
}

/// @throws std::runtime_error  there is not enough memory
inline Object clone_of(const Object& object)
{
    return value_of(object.clone());
}

/// Calls `take` with each piece: those of the positive side, then those of the negative one.
template <class Take>
void for_each_piece(Cut& cut, Take take)
{
    for (const Side side : {Side::positive, Side::negative})
        for (std::size_t i = 0; Object* const piece = cut.piece(side, i); ++i) take(*piece);
}

}  // namespace kerf::bench
