#pragma once

#include <utility>

#include "common/repair/repair.h"
#include "common/shapes/shapes.h"

namespace kerf::app {

/// A boulder of so many triangles.
inline ProvenMesh stone_asteroid(std::uint64_t triangles, std::uint64_t seed)
{
    TriangleSoup soup = shapes::asteroid(triangles, seed);
    Material rock;
    rock.name = "rock";
    rock.colour = {0.30f, 0.26f, 0.225f, 1.0f};
    soup.materials = {rock};
    return repair(std::move(soup)).mesh;
}

}  // namespace kerf::app
