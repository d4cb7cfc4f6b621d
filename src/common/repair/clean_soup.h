#pragma once

#include <cstdint>

#include "common/mesh/triangle_soup.h"

// Where the numbers of a soup are made fit for use, whether a file or a program gave them.

namespace kerf::core {

/// The normal of a vertex that has none, until clean() gives it one.
inline constexpr glm::vec3 kNoNormal{0.0f};

/// The vertices that had a number that is not finite.
struct UnfitAttributes
{
    std::uint64_t normals = 0;
    std::uint64_t uvs = 0;
    std::uint64_t vertices = 0;  ///< with one or both
};

/// Cleans the numbers of vertices. All positions are finite, and indices in range.
///
/// * -0 becomes +0 in positions, so that equal positions have equal bits.
/// * A normal farther than kUnitTolerance from unit length is normalised; a nearer one keeps its bits. A vertex has none if
///   its normal is not finite or has length 0: it gets the mean of its triangles' normals, weighted by area, or +z
///   if that has no direction. If no vertex has one, `has_normals` becomes false.
/// * A uv that is not finite becomes (0, 0).
///
/// Does nothing to a soup that is clean. O(n).
UnfitAttributes clean(TriangleSoup& soup);

/// Sets the values of streams that are not finite to 0, and returns their number. For files; a program may give them a
/// meaning. O(n).
std::uint64_t clean_streams(TriangleSoup& soup);

}  // namespace kerf::core
