#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"
#include "halfedge/universe/triangle_tree.h"

namespace kerf::core::halfedge {

/// On which sides of the plane the corners of a leaf's triangles lie, and how far from it.
class LeafDistances
{
public:
    /// For at most kMaxLeafTriangles triangles. The distances are Plane::signed_distance(), bit for bit. O(triangles).
    void find(const Plane& plane, std::span<const Vertex> vertices, std::span<const Triangle> triangles);

    /// The signed distances of a triangle's corners.
    std::array<double, 3> of(std::size_t triangle) const
    {
        const std::array<double, 4>& d = distances_[triangle];
        return {d[0], d[1], d[2]};
    }
    /// Whether a corner of a triangle lies above the plane, below it, or on it.
    bool is_above(std::size_t triangle) const { return above_[triangle] != 0; }
    bool is_below(std::size_t triangle) const { return below_[triangle] != 0; }
    bool is_on(std::size_t triangle) const { return (above_[triangle] | below_[triangle]) != kAllCorners; }
    /// A bit for each corner of a triangle: whether it lies above the plane.
    unsigned corners_above(std::size_t triangle) const { return above_[triangle]; }

    /// A bit for each triangle.
    struct Masks
    {
        std::uint64_t crossing = 0;  ///< it has corners above the plane and below it
        std::uint64_t on = 0;        ///< a corner lies on the plane
        std::uint64_t above = 0;     ///< a corner lies above it
    };
    /// Of the first `count` triangles. O(kMaxLeafTriangles / 8).
    Masks masks(std::size_t count) const;

private:
    static constexpr std::uint8_t kAllCorners = 0b111;
    static_assert(kMaxLeafTriangles % 8 == 0 && kMaxLeafTriangles < 64);

    void find_one_by_one(const Plane& plane, std::span<const Vertex> vertices, std::span<const Triangle> triangles);
    void find_three_at_once(const Plane& plane, std::span<const Vertex> vertices, std::span<const Triangle> triangles);

    std::array<std::array<double, 4>, kMaxLeafTriangles>
        distances_;                                                  // of a triangle: three, and one that means nothing
    std::array<std::uint8_t, kMaxLeafTriangles> above_{}, below_{};  // of a triangle: a bit for each corner
};

}  // namespace kerf::core::halfedge
