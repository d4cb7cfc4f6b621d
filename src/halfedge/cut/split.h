#pragma once

#include "halfedge/cut/find.h"

namespace kerf::core::halfedge {

/// Which points of a section coincide with others. Nearly always none.
struct Coincidences
{
    bool irregular = false;       ///< some cut points coincide with vertices or each other, or edges lie in the plane
    bool collapsed = false;       ///< a cut point fell on a corner off the plane, or on another: sub-triangles vanish
    bool meets_boundary = false;  ///< the section runs through a vertex on the boundary of the mesh
};

/// SPLIT: says of each crossing triangle how it falls apart, and what lies beyond its crossed edges by the numbers that
/// FIND gave: FaceStamps or FaceTable. O(k).
template <class Numbers>
Coincidences split_crossings(const Universe& universe, const Numbers& numbers, Found& found);

}  // namespace kerf::core::halfedge
