#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "common/cutting/cut.h"

// The baseline: the report's slicer, a loop over all triangles with four ways to look up vertices and a fan for a cap.

namespace kerf::core::baseline {

/// How the baseline finds out whether a fragment has a vertex already. n is the number of triangles.
enum class VertexLookup : std::uint8_t
{
    scan,             ///< the report's first method, a loop over all vertices of the fragment: O(n^2)
    two_bucket_hash,  ///< what the report's program did: a dictionary whose hash takes two values: O(n^2)
    hash,             ///< the report's "better approach", a dictionary with a proper hash: O(n)
    remap,            ///< tables from old to new vertex index; only cut edges are looked up: O(n), and the fastest
};
std::string_view name_of(VertexLookup lookup);

/// The report's method (section 3): a loop over every triangle of an indexed mesh and a fan over the section's mean
/// point. A lookup that does not exist means `hash`. The report also rewrites every vertex around its fragment's new
/// pivot; here coordinates never change, because a pivot belongs in the fragment's transform, and only the benchmark
/// runs that loop.
std::unique_ptr<Backend> make_back_end(VertexLookup lookup = VertexLookup::hash);

}  // namespace kerf::core::baseline
