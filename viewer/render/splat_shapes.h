#pragma once

#include <cstdint>
#include <vector>

namespace kerf::render {

/// Outlines of juice that hit a wall, as heights: a body, rays that it threw out, droplets at their ends and mist. They
/// are made once; a stain turns and mirrors one of them.
struct SplatShapes
{
    static constexpr int kShapes = 8;
    static constexpr int kSide = 512;          ///< texels
    static constexpr float kReach = 1.75f;     ///< from the middle to the side, in radii of the stain
    static constexpr float kEdge = 0.25f;      ///< the height at which juice begins
    static constexpr float kMostSlope = 8.0f;  ///< heights a radius that a channel can hold

    /// kShapes squares of kSide x kSide texels, one after the other, rows from below: height, slope to the right, slope
    /// upwards (128: level), 255. Heights fall to 0 at the sides.
    std::vector<std::uint8_t> texels;

    const std::uint8_t* texel(int shape, int x, int y) const
    {
        return texels.data() + 4 * ((static_cast<std::size_t>(shape) * kSide + static_cast<std::size_t>(y)) * kSide +
                                    static_cast<std::size_t>(x));
    }
};

/// The same shapes each time. Heights are sums of round kernels, so that juice flows together where it is close
/// (Blinn, "A generalization of algebraic surface drawing", 1982). O(texels)
SplatShapes make_splat_shapes();

}  // namespace kerf::render
