#pragma once

#include <kerf/object.h>

#include <cstdint>
#include <string>
#include <vector>

namespace kerf::bench {

/// A back end that is timed.
struct TimedBackEnd
{
    std::string name;
    /// Largest mesh that it is given, in triangles: quadratic methods stop where a cut takes seconds.
    std::uint64_t most_triangles;

    Result<Object> prepare(Mesh mesh) const;
};

/// All back ends of this build, the default last.
const std::vector<TimedBackEnd>& back_ends();

}  // namespace kerf::bench
