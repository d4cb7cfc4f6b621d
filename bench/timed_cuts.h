#pragma once

#include <benchmark/benchmark.h>
#include <kerf/mesh.h>
#include <kerf/plane.h>

#include <cstdint>
#include <span>
#include <string>

#include "bench/back_ends.h"

namespace kerf::bench {

/// How much of a cut is timed.
enum class Extent : std::uint8_t
{
    geometry,    ///< two closed fragments with all attributes
    whole_chain  ///< all that a game needs: mass properties, a bounded hull each and the draw views, too
};

/// Times cuts of clones of a mesh: an iteration is one round over all planes, so that every mean is over the same cuts
/// however often is timed (the counter `cuts_each` says how many; times per cut are the iteration's divided by it). Cloning
/// the input and destroying the fragments stay untimed. Counters have what the cuts cost, and milliseconds by phase. What is
/// not cut right (check_cut()) is an error, and not timed.
///
/// @param name  of the mesh: the same for the same mesh, which is then prepared and checked once for several extents
void time_cuts(benchmark::State& state, const TimedBackEnd& back_end, const Mesh& mesh, const std::string& name,
               std::span<const Plane> planes, Extent extent);

}  // namespace kerf::bench
