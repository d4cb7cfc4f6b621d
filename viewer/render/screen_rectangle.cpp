#include "viewer/render/screen_rectangle.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace kerf::render {

ScreenRectangle screen_rectangle(const Box& box, const glm::mat4& to_clip, int width, int height)
{
    glm::vec2 low(std::numeric_limits<float>::infinity()), high(-low);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place((corner & 1) != 0 ? box.hi.x : box.lo.x, (corner & 2) != 0 ? box.hi.y : box.lo.y,
                              (corner & 4) != 0 ? box.hi.z : box.lo.z);
        const glm::vec4 clip = to_clip * glm::vec4(place, 1.0f);
        // What is behind the eye has no place on the screen.
        if (!(clip.w > 1e-6f)) return {0, 0, width, height};
        low = glm::min(low, glm::vec2(clip) / clip.w);
        high = glm::max(high, glm::vec2(clip) / clip.w);
    }
    // A pixel more on each side: samples are not in the middle, and numbers are rounded.
    const auto pixel = [](float ndc, int size, float margin) {
        const float place = (0.5f + 0.5f * ndc) * static_cast<float>(size) + margin;
        return static_cast<int>(std::floor(std::clamp(place, 0.0f, static_cast<float>(size))));
    };
    const int left = pixel(low.x, width, -1.0f), bottom = pixel(low.y, height, -1.0f);
    return {left, bottom, pixel(high.x, width, 2.0f) - left, pixel(high.y, height, 2.0f) - bottom};
}

}  // namespace kerf::render
