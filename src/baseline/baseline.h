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
/// point. `rewrite_pivots`: also run the report's loop that rewrites every vertex around the fragment's new pivot; its
/// result goes to scratch memory, because coordinates never change (a fragment's pivot belongs in its transform). A
/// lookup that does not exist means `hash`.
std::unique_ptr<Backend> make_back_end(VertexLookup lookup = VertexLookup::hash, bool rewrite_pivots = false);

}  // namespace kerf::core::baseline
