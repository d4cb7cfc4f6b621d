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

    /// The half-edge back end with another closing of sections: whatever has little to do with caps is not timed again.
    bool differs_in_caps_only() const { return name == "halfedge/cgal"; }

    Result<Object> prepare(Mesh mesh, unsigned threads = 1) const;
};

/// All back ends of this build, the default last.
const std::vector<TimedBackEnd>& back_ends();

}  // namespace kerf::bench
