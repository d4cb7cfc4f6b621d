#include "common/sections/loop_nesting.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/dominant_axis.h"

namespace kerf::core {

namespace {

Box box_of(PlanarLoop loop)
{
    Box box;
    for (const PlanarPoint& p : loop) box.add(glm::vec3(p.u, p.v, 0.0f));
    return box;
}

}  // namespace

std::span<const std::uint32_t> LoopNesting::find(const Plane& plane, const PlaneSection& section)
{
    parents_.assign(section.paths.size(), kNoContainer);
    loops_.clear();
    // Of shapes of one size those that come later may lie in the others.
    collect(section, true);
    collect(section, false);
    if (loops_.size() < 2) return parents_;

    flatten(plane, section);
    containment_.begin(outlines_);
    // One pointer, so that the function needs no memory of its own.
    const std::span<const std::uint32_t> containers = search_.find(
        shapes_, [this](std::uint32_t outer, std::span<const std::uint32_t> candidates,
                        std::span<std::uint8_t> lies_in) { containment_.decide(outer, candidates, lies_in); });
    for (std::size_t i = 0; i < loops_.size(); ++i)
        if (containers[i] != kNoContainer) parents_[loops_[i]] = loops_[containers[i]];
    return parents_;
}

/// Collects the loops that are holes, or those that are not.
void LoopNesting::collect(const PlaneSection& section, bool holes)
{
    for (std::uint32_t i = 0; i < section.paths.size(); ++i) {
        const PlaneSection::Path& path = section.paths[i];
        if (path.closed && (path.area < 0.0) == holes) loops_.push_back(i);
    }
}

void LoopNesting::flatten(const Plane& plane, const PlaneSection& section)
{
    const int axis = dominant_axis(plane.normal), u = (axis + 1) % 3, v = (axis + 2) % 3;
    points_.clear();
    for (const glm::vec3& p : section.points) points_.push_back({p[u], p[v]});
    outlines_.clear();
    shapes_.clear();
    for (const std::uint32_t loop : loops_) {
        const PlaneSection::Path& path = section.paths[loop];
        const PlanarLoop outline = std::span(points_).subspan(path.first_point, path.point_count);
        const Box box = box_of(outline);
        outlines_.push_back(outline);
        shapes_.push_back({box, std::abs(twice_area(outline, box)), true, true});
    }
}

}  // namespace kerf::core
