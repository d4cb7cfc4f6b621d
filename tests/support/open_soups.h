#pragma once

#include <cstdint>
#include <string>

#include "common/mesh/plane.h"
#include "common/mesh/triangle_soup.h"
#include "support/fixtures.h"

// Open meshes that touch themselves: what a cut finds there begins and ends in many places, several of them at one
// point.

namespace kerf::core::test {

/// A soup with a name for failure messages.
struct NamedSoup
{
    std::string name;
    TriangleSoup soup;
};

/// Triangles over a few points of a lattice, sheets that meet along edges, tori and boxes without some of their
/// triangles, open boxes stacked, closed shapes without a third: most are on a lattice, so that planes go through
/// vertices, along edges and in faces. At most about `triangles` triangles, a dozen at least. The same for equal
/// numbers.
NamedSoup open_soup(std::uint64_t seed, std::uint32_t triangles);

/// A sphere without random triangles, each of which leaves three boundary edges: thousands of them for ten thousand
/// triangles. Its vertices are on a lattice of `cells` across, or where they are for 0.
TriangleSoup sieve(std::uint64_t seed, std::uint32_t triangles, double left_out, std::uint32_t cells);

/// A plane across a mesh that mostly goes through its vertices: along an axis or a diagonal of the lattice, or as
/// planes_for() has them.
Plane plane_across(const IndexedMesh& mesh, std::uint64_t seed);

}  // namespace kerf::core::test
