#pragma once

#include <span>
#include <string>

#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// Empty when everything that the fragment over `shells` refers to is consistent; otherwise one sentence that names the
/// first thing that is wrong. Looks at connectivity (opposite, next, previous, face, vertex, vertex fans), at positions
/// of half-edge mesh and vertex buffer, at boxes, moments, maxima and groups of the tree, and at slots that occur
/// twice. For tests; O(n), shares no code with what it checks beyond the data structures.
std::string check_universe(const Universe& universe, std::span<const ShellRoot> shells);

}  // namespace kerf::core::halfedge
