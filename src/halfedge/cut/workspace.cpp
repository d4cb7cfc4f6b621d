#include "halfedge/cut/workspace.h"

#include <algorithm>
#include <limits>

namespace kerf::core::halfedge {

void CutWorkspace::reserve(std::size_t crossings)
{
    finder.reserve(crossings);
    found.reserve(crossings);
    walker.reserve(crossings);
    section.reserve(crossings);
    caps.reserve(crossings);
}

void CutWorkspace::begin(Universe& u)
{
    // Stamps of earlier cuts lie below the base. Starting again from 1 once in 2^31 crossing triangles costs O(n).
    if (u.stamp_base >= std::numeric_limits<Index>::max() / 2) {
        std::fill(u.stamp_of_face.begin(), u.stamp_of_face.end(), Index(0));
        u.stamp_base = 1;
    }
}

void CutWorkspace::end(Universe& u)
{
    u.stamp_base += found.crossings.size() + part_finder.stamps_used();
    part_finder.forget_stamps();
    clear();
}

void CutWorkspace::clear()
{
    found.clear();
    section.clear();
    section_numbers.clear();
    pieces.clear();
    caps.clear();
}

}  // namespace kerf::core::halfedge
