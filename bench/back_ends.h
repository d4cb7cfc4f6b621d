#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/cutting/cut.h"

namespace kerf::bench {

/// A back end that is timed.
struct TimedBackend
{
    std::shared_ptr<Backend> backend;
    /// Largest mesh that it is given, in triangles: quadratic methods stop where a cut takes seconds.
    std::uint64_t most_triangles;
};

/// All back ends of this build, the default last.
const std::vector<TimedBackend>& back_ends();

}  // namespace kerf::bench
