#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "common/mesh/indexed_mesh.h"

// Triangulation of a file's polygons without a new vertex.

namespace kerf::core::io {

/// The most corners of a face that is not convex: triangulating it takes quadratic time, here about a second.
inline constexpr std::size_t kMostConcaveCorners = 1 << 14;

/// Limit on what all faces of a file that are not convex may cost: as much as four of the largest ones.
class ConcaveBudget
{
public:
    /// Whether there is enough left for such a face; takes it. Short faces are free: they cost as much as reading them.
    bool spend(std::size_t corners)
    {
        if (corners <= kFreeCorners) return true;
        if (corners > kMostConcaveCorners || corners * corners > left_) return false;
        left_ -= corners * corners;
        return true;
    }

private:
    static constexpr std::size_t kFreeCorners = 64;
    std::uint64_t left_ = 4 * std::uint64_t(kMostConcaveCorners) * kMostConcaveCorners;
};

/// Cuts a polygon with at least three corners into corners - 2 triangles over the same corners, no vertex added, and
/// appends them. A convex one becomes a fan from its first corner, in O(n); any other is clipped ear by ear, seen along
/// the axis in which its plane is widest (Meisters 1975), in O(n^2). An outline that crosses itself or has no area gets
/// triangles too, some of them folded over.
///
/// @param indices   vertex index of each corner
/// @param vertices  positions are looked up here
/// @return false, and nothing appended, for a polygon that is not convex and too much for the budget
bool triangulate_polygon(std::span<const std::uint32_t> indices, std::span<const Vertex> vertices,
                         Buffer<Triangle>& triangles, ConcaveBudget& budget);

}  // namespace kerf::core::io
