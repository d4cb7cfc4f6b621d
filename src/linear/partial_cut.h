#pragma once

#include <functional>

#include "linear/closing.h"
#include "linear/slices.h"

namespace kerf::core::linear {

/// Cuts a fragment: a Slicer's run().
using RunSlicer = std::function<Slices(const Fragment& whole, const CutOptions& options)>;

/// CutOptions::only: a cut along some of the outline. The pieces of the whole cut say what the chosen paths part, and what
/// they do not; then the cut is made once more, and every triangle goes where they say. Two cuts, and copies: O(n). May
/// throw std::bad_alloc.
///
/// @param closing  closes the sides
/// @param run      cuts along all of the outline
Slices cut_only(const Fragment& whole, const Plane& plane, const CutOptions& options, Closing& closing,
                const RunSlicer& run);

}  // namespace kerf::core::linear
