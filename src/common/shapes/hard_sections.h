#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/mesh/plane.h"
#include "common/mesh/triangle_soup.h"

// Sections on which a quadratic method takes minutes: for tests and benchmarks of the worst cost of cuts.

namespace kerf::core::shapes {

/// A closed mesh, and a plane whose section is hard for a cutter.
struct HardSection
{
    TriangleSoup soup;
    Plane plane;
};

/// Names that hard_section() knows:
///   bricks         a block with cavities that touch in T-junctions: n loops that lie on one another's edges
///   checkerboard   a block with cavities that touch along edges: n loops that share corners
///   comb           one loop of n points that goes to and fro
///   flat           n triangles in the plane
///   flat_rough     the same, with heights that are off by some units in the last place: loops everywhere
///   flat_tilted    the same as flat, and a plane that is tilted by 1e-7
///   hidden_pores   a comb that falls into n teeth, with a cavity in each that the plane does not reach
///   leaning_comb   as comb, with teeth that lean over half of the others: all bounds overlap
///   loose_parts    n boxes side by side: n loops of as many solids
///   nested_shells  n spheres in one another, alternately solids and cavities
///   pores          a block with n cavities: as many holes in one cap
///   rosette        n loops that have one point in common
///   spiral         one loop of n points that winds fifty times
///   stack          n tetrahedra in one another with a corner and three edges in common: cut points in three lines
///   teeth          a comb that falls into n teeth: n loops of one shell
///   tip            a double cone of 2n triangles and a plane that passes its tip by a unit in the last place:
///                  thousands of cut points practically in one place
///   toothed_tip    the same with a rim of teeth: long edges side by side between thousands of points at the tip
///   touches        a comb of n points, each tooth of which has a corner that is folded over by 1e-20
///   wedges         n tetrahedra around one edge: as many cut points in one place
const std::vector<std::string>& hard_section_names();

/// A hard section of about size `n`; empty for an unknown name. O(n).
std::optional<HardSection> hard_section(std::string_view name, std::uint32_t n);

}  // namespace kerf::core::shapes
