#pragma once

#include <utility>

#include "common/assemble.h"
#include "common/shapes.h"

namespace kerf::app {

/// A boulder of so many triangles.
inline IndexedMesh stone_asteroid(std::uint64_t triangles, std::uint64_t seed)
{
    TriangleSoup soup = shapes::asteroid(triangles, seed);
    Material stone;
    stone.name = "stone";
    stone.colour = {0.52f, 0.50f, 0.46f, 1.0f};
    soup.materials = {stone};
    return assemble(std::move(soup)).mesh;
}

}  // namespace kerf::app
