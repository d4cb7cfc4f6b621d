#pragma once

#include <vector>

#include "common/cutting/plane_section.h"
#include "common/mesh/plane.h"
#include "halfedge/cut/workspace.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// The outline of a section without a cut: by QuickOutline or, if that says so, as a cut finds it. The universe stays as it
/// is. O(s log(n / s) + k). May throw std::bad_alloc.
///
/// @param universe   locked for reading
/// @param workspace  that no cut and no other outline uses meanwhile; empty, and empty again afterwards
/// @param section    clear
void find_outline(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane,
                  CutWorkspace& workspace, PlaneSection& section);

/// The same by FIND, SPLIT and WALK of a cut with numbers and points of their own, whatever meets whatever. It is known
/// that the plane does not miss.
void find_outline_as_a_cut(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane,
                           CutWorkspace& workspace, PlaneSection& section);

/// The loops and chains of WALK as a section without a cut has them, behind those that are there. O(k). May throw
/// std::bad_alloc.
void copy_paths(const Universe& universe, const Found& found, const Section& from, PlaneSection& to);

}  // namespace kerf::core::halfedge
