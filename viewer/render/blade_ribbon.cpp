#include "viewer/render/blade_ribbon.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace kerf::render {

namespace {

std::vector<BladePoint> apart(std::span<const BladePoint> path, float least)
{
    std::vector<BladePoint> kept;
    for (const BladePoint& point : path)
        if (kept.empty() || glm::distance(kept.back().place, point.place) > least) kept.push_back(point);
    return kept;
}

}  // namespace

std::vector<RibbonVertex> blade_ribbon(std::span<const BladePoint> path, float width)
{
    const std::vector<BladePoint> points = apart(path, width / 50.0f);
    std::vector<RibbonVertex> strip;
    if (points.size() < 2) return strip;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec2 before = points[i == 0 ? 0 : i - 1].place,
                        after = points[std::min(i + 1, points.size() - 1)].place;
        // Where the path turns back on itself the neighbours may coincide.
        glm::vec2 along = after - before;
        if (glm::length(along) < 1e-6f) along = points[i].place - before;
        along = glm::length(along) < 1e-6f ? glm::vec2(1.0f, 0.0f) : glm::normalize(along);
        const float half = 0.5f * width * points[i].life;
        const glm::vec2 side = half * glm::vec2(-along.y, along.x);
        strip.push_back({points[i].place + side, 1.0f, points[i].life});
        strip.push_back({points[i].place - side, -1.0f, points[i].life});
    }
    // The tip: the ribbon ends in a point just ahead of where the blade is.
    const BladePoint& last = points.back();
    const glm::vec2 ahead = glm::normalize(last.place - points[points.size() - 2].place);
    strip.push_back({last.place + 0.8f * width * ahead, 0.0f, last.life});
    return strip;
}

}  // namespace kerf::render
