#include "common/sections/section_fill.h"

#include "common/geometry/containment.h"

namespace kerf::core {

namespace {

/// The outer loop that a path is closed with: a hole with the smallest one of its solid around it. A hole without one is
/// closed alone.
std::uint32_t outer_loop(const PlaneSection& section, std::span<const std::uint32_t> parents, std::uint32_t path)
{
    if (section.paths[path].area >= 0.0) return path;
    for (std::uint32_t around = parents[path]; around != kNoContainer; around = parents[around])
        if (section.paths[around].area > 0.0 && section.paths[around].solid == section.paths[path].solid) return around;
    return path;
}

}  // namespace

void SectionFill::close(const Plane& plane, CapQuality quality, std::span<const std::uint32_t> parents,
                        PlaneSection& section, std::vector<std::uint32_t>& corners)
{
    loops_.clear();
    caps_.clear();
    for (std::uint32_t i = 0; i < section.paths.size(); ++i) {
        const PlaneSection::Path& path = section.paths[i];
        if (path.closed) loops_.push_back({path.first_point, path.point_count, outer_loop(section, parents, i)});
    }
    closer_.close(plane, loops_, quality, section.points, caps_);
    corners.clear();
    corners.reserve(3 * caps_.triangles.size());
    for (const CapTriangle& triangle : caps_.triangles)
        corners.insert(corners.end(), triangle.corner.begin(), triangle.corner.end());
}

}  // namespace kerf::core
