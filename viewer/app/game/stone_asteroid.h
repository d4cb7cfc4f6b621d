#pragma once

#include <kerf/shapes.h>

#include <new>

namespace kerf::app {

/// A boulder of so many triangles. @throws std::bad_alloc
inline Mesh stone_asteroid(std::uint64_t triangles, std::uint64_t seed)
{
    const Material rock{"rock", {0.30f, 0.26f, 0.225f, 1.0f}};
    ShapeOptions options;
    options.seed = seed;
    options.material = &rock;
    Result<Mesh> boulder = make_shape("asteroid", triangles, options);
    if (!boulder) throw std::bad_alloc();
    return *std::move(boulder);
}

}  // namespace kerf::app
