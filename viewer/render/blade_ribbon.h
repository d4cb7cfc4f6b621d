#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace kerf::render {

/// A point of the blade's path on the screen.
struct BladePoint
{
    glm::vec2 place{0.0f};  ///< pixels, in any frame in which both axes have the same unit
    float life = 1.0f;      ///< 1: just drawn, 0: about to vanish
};

/// A corner of the ribbon; shaders/blade.vert reads it as it lies here.
struct RibbonVertex
{
    glm::vec2 place{0.0f};
    float across = 0.0f;  ///< -1 to 1 over the ribbon's width
    float life = 1.0f;
};

/// A triangle strip along the path, `width` wide where it was just drawn and pointed where it vanishes. Points closer
/// together than a fiftieth of the width are joined. Empty for fewer than two different points.
std::vector<RibbonVertex> blade_ribbon(std::span<const BladePoint> path, float width);

}  // namespace kerf::render
