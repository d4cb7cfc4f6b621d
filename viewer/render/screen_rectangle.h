#pragma once

#include <kerf/math.h>

#include <cstdint>
#include <glm/mat4x4.hpp>

namespace kerf::render {

/// Pixels of a picture: from x and y, which count from the lower left corner, so many to the right and up.
struct ScreenRectangle
{
    int x = 0, y = 0, width = 0, height = 0;

    bool is_empty() const { return width <= 0 || height <= 0; }
    std::int64_t pixels() const { return is_empty() ? 0 : std::int64_t{width} * height; }
};

/// The part of a picture of this size in which a box may be seen. Nothing of the box is seen elsewhere.
/// @param to_clip  the box's coordinates to clip space
ScreenRectangle screen_rectangle(const Box& box, const glm::mat4& to_clip, int width, int height);

}  // namespace kerf::render
