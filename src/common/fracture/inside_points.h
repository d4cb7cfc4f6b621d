#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "common/mesh/triangle_search.h"
#include "common/support/random.h"

namespace kerf::core {

/// Where a closed surface has its inside, as lines through it find it: a sample of the solid.
class InsideSample
{
public:
    /// Sends `lines` parallel lines through the box of the triangles, at random, along its shortest side, and more as long as
    /// too few of them meet the solid. O(n + h) for n triangles that are found and h places where lines meet them. Nothing
    /// depends on the order of the triangles.
    InsideSample(const TriangleSearch& triangles, std::size_t lines, Random& random);

    /// Whether no line has met an inside.
    bool is_empty() const { return runs_.empty(); }
    /// A point inside, each place as likely as any other. There is an inside. O(log r) for r runs.
    glm::dvec3 point(Random& random) const;
    /// Calls visit(from, axis, length) for each part of a line that lies inside. O(r) for r runs.
    template <class Visit>
    void for_each_run(Visit visit) const
    {
        for (const Run& run : runs_) visit(run.from, axis_, run.length);
    }

private:
    /// A part of a line that lies inside.
    struct Run
    {
        glm::dvec3 from;
        double length = 0.0;
        double sum = 0.0;  ///< of the lengths up to its end
    };

    int axis_ = 0;
    std::vector<Run> runs_;
};

}  // namespace kerf::core
