#pragma once

#include "halfedge/cut/section.h"

namespace kerf::core::halfedge {

class OutlineLinker;

/// WALK: goes from every crossing triangle that is not seen yet over opposite half-edges until the loop closes or ends.
/// Each crossed edge gets one cut point, and one new vertex, or two at a seam. The points of an irregular outline then
/// say how it is linked. O(k), and what OutlineLinker::link() costs.
class Walker
{
public:
    void reserve(std::size_t crossings_expected);
    /// There is room for the new vertices, which come behind the universe's. Notes the cut points in the crossing
    /// triangles. May throw std::bad_alloc.
    void run(Universe& universe, const Plane& plane, const Coincidences& coincidences, OutlineLinker& linker,
             Found& found, Section& section);
    /// The same loops without new vertices: nothing but `found` and `section` changes.
    void run_outline(const Universe& universe, const Plane& plane, const Coincidences& coincidences,
                     OutlineLinker& linker, Found& found, Section& section);

private:
    template <class NewVertices>
    void run_with(NewVertices vertices, const Universe& universe, const Plane& plane, const Coincidences& coincidences,
                  OutlineLinker& linker, Found& found, Section& section);

    std::vector<Index> run_;  // crossing triangles in a row
};

}  // namespace kerf::core::halfedge
