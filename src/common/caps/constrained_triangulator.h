#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"
#include "common/caps/edge_routes.h"

// The ways that need CGAL, which is GPL. They are defined in one file, in the library `caps_cgal`, which puts them in place
// when a program that links it starts. Until then, and in programs without it, the first is that of
// nested_triangulator.h, and the second refuses everything.

namespace kerf::core {

/// Concave and nested loops: constrained Delaunay triangulation of spatially sorted points, then winding numbers by
/// flooding from outside. Refuses outlines that cross or touch themselves inside an edge. O(k log k).
std::unique_ptr<CapTriangulator> make_constrained_triangulator();

/// By a constrained Delaunay triangulation whose constraints may cross.
std::unique_ptr<RouteFinder> make_route_finder();

/// Whether the two functions above give ways that need CGAL.
bool has_constrained_ways() noexcept;

/// Both ways.
struct ConstrainedWays
{
    std::unique_ptr<CapTriangulator> (*make_triangulator)();
    std::unique_ptr<RouteFinder> (*make_route_finder)();
};

/// What the first two functions above call from now on, in all threads; null: those without CGAL. `ways` must outlive all
/// calls.
void use_constrained_ways(const ConstrainedWays* ways) noexcept;

}  // namespace kerf::core
