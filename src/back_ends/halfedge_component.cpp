#include "back_ends/back_ends.h"
#include "halfedge/halfedge.h"

// Puts the half-edge back end on the list. It is a library of its own: a program that does not link it has no half-edge
// back end, and needs no OpenMesh.

namespace kerf::core {

namespace {

/// On the list before main() begins.
[[maybe_unused]] const bool is_on_list = [] {
    add_back_end({.name = "halfedge", .make = [] { return halfedge::make_back_end(); }, .is_for_many_cuts = true});
    add_back_end(
        {.name = "halfedge/cgal", .make = [] { return halfedge::make_back_end_with_cgal(); }, .needs_cgal = true});
    return true;
}();

}  // namespace

}  // namespace kerf::core

/// By this name linkers are told to take this file (`-u`), which nothing else refers to. Shown by shared libraries of Kerf
/// alone: if one of somebody's showed it, linkers would take that for this, and leave this file out of the program.
extern "C" const int kerf_component_halfedge;
extern "C" const int kerf_component_halfedge = 1;
