#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "viewer/ui/canvas.h"

namespace kerf::app {

/// Where the stages of a round are on the picture: one that fills it, or several side by side.
struct StageLayout
{
    std::size_t stages = 1;
    double zoom = 1.0;  ///< how much larger a stage is shown than the shape of its part asks for

    /// A stage's part of a picture of this size. Pixels from the upper left corner.
    ui::Box2 box(std::size_t stage, const glm::vec2& size) const
    {
        const float first = static_cast<float>(stage) / static_cast<float>(stages);
        const float last = static_cast<float>(stage + 1) / static_cast<float>(stages);
        return {{first * size.x, 0.0f}, {last * size.x, size.y}};
    }
    /// The one whose part this place is in.
    std::size_t stage_at(const glm::vec2& place, const glm::vec2& size) const
    {
        std::size_t stage = 0;
        while (stage + 1 < stages && place.x >= box(stage, size).high.x) ++stage;
        return stage;
    }
};

}  // namespace kerf::app
