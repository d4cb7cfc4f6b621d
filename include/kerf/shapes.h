#pragma once

#include <kerf/export.h>
#include <kerf/mesh.h>

#include <cstddef>
#include <cstdint>

// Generated meshes to try things with. Component `shapes`.

namespace kerf {

/// The most triangles that a shape is asked for.
inline constexpr std::uint64_t kMostShapeTriangles = 16'000'000;

/// A closed shape by its name with about so many triangles (at least what it needs, at most
/// kMostShapeTriangles). Only the asteroid uses the seed.
/// O(n log n). Status: `invalid_argument` for a name that is none of shape_name(), `out_of_memory`.
KERF_API Result<Mesh> make_shape(const char* name, std::uint64_t triangles, std::uint64_t seed = 1) noexcept;

/// "asteroid", "bowl", "box", ...; null beyond the last.
KERF_API const char* shape_name(std::size_t i) noexcept;

}  // namespace kerf
