#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/repair/repair.h"

// Generated shapes: the shared fixtures of tests, benchmarks and viewer. Each is closed by bit-equal positions
// (vertices at seams are exact copies), manifold, consistently oriented with the outside out, free of degenerate
// triangles, with unit normals and uv, and centred on the origin unless said otherwise. Give them to repair().
//
// Equal arguments give equal bytes on one machine; round shapes take sin and cos from the C library, so their last bits
// may differ between libraries. Counts below what a shape needs (no cell, two slices, ...) are raised to it; a shape of
// more than 2^32 corners throws std::length_error. Any size is accepted: 0, or a size that is not finite, gives
// triangles that repair() drops or refuses.
// `asteroid`, `shuffled` and all random numbers use exactly rounded operations only and are the same everywhere.

namespace kerf::core::shapes {

/// The most triangles that make() asks a generator for, and the most of asteroid(): 16 million.
inline constexpr std::uint64_t kMostTriangles = 16'000'000;

/// Sphere from an icosahedron whose faces are divided into frequency^2 triangles: 20 * frequency^2 triangles.
/// uv: the unfolded icosahedron, ten rhombi.
TriangleSoup icosphere(float radius, std::uint32_t frequency);

/// Sphere in rings and slices around z, uv seam and poles included: 2 * slices * (rings - 1) triangles. slices >= 3,
/// rings >= 2.
TriangleSoup uv_sphere(float radius, std::uint32_t slices, std::uint32_t rings);

/// Box with each face divided into a grid of n.x, n.y, n.z cells: 4 * (nx*ny + ny*nz + nz*nx) triangles, sharp edges.
TriangleSoup box(const glm::vec3& size, const glm::uvec3& cells);

/// Cylinder around z with flat ends (fans): 2 * slices * (stacks + 1) triangles.
TriangleSoup cylinder(float radius, float height, std::uint32_t slices, std::uint32_t stacks = 1);

/// Cone around z, apex up: 2 * slices triangles.
TriangleSoup cone(float radius, float height, std::uint32_t slices);

/// Torus around z: 2 * major * minor triangles.
TriangleSoup torus(float major_radius, float minor_radius, std::uint32_t major, std::uint32_t minor);

/// Tube around z, open through the middle but closed as a surface: an annulus at both ends. 4 * slices * (stacks + 1)
/// triangles.
TriangleSoup pipe(float outer_radius, float inner_radius, float height, std::uint32_t slices, std::uint32_t stacks = 1);

/// Half a hollow ball, open upwards, its rim in z = 0: 4 * slices * rings triangles. A plane across z gives a ring, one
/// below the inside a disc.
TriangleSoup bowl(float radius, float thickness, std::uint32_t slices, std::uint32_t rings);

/// A bar along x with `teeth` >= 1 teeth along +y: a plane across the teeth gives one loop for each. 24 * teeth - 4
/// triangles.
TriangleSoup comb(std::uint32_t teeth);

/// A block of 2 x 1 x 2 without its upper quarter at +x: a step. Many edges and faces lie in axis planes through the
/// origin. 28 * cells^2 triangles.
TriangleSoup l_step(std::uint32_t cells);

/// A beam of 3 x 1 x 1 on two legs of 1 x 1 x 1 along -z: a plane across the legs gives two loops and, below, two
/// pieces. 44 * cells^2 triangles.
TriangleSoup two_legs(std::uint32_t cells);

/// A block of 3 x 3 x 2 with a well of 1 x 1 x 1 in the top: 92 * cells^2 triangles.
TriangleSoup tray(std::uint32_t cells);

/// A wall of constant thickness that winds `turns` times around z, growing outwards (so not centred in x and y): a
/// plane across z gives one long concave loop. 8 * segments + 4 triangles for turns * segments_per_turn segments.
TriangleSoup spiral_wall(float turns, std::uint32_t segments_per_turn);

/// Menger sponge of side 1, `level` 0 to 4 (more is taken as 4): all faces on the lattice of the smallest cubes.
/// 4 * 20^level + 8 * 8^level triangles.
TriangleSoup menger_sponge(std::uint32_t level);

/// Concentric spheres, the largest first, alternately outside out and inside out: with two radii a hollow ball, with
/// three a ball inside a hollow one. 20 * frequency^2 triangles each.
TriangleSoup nested_spheres(std::span<const float> radii, std::uint32_t frequency);

/// A sphere with a concentric spherical cavity (an inner shell that is inside out): 40 * frequency^2 triangles.
TriangleSoup sphere_in_sphere(float outer_radius, float inner_radius, std::uint32_t frequency);

/// Two spheres with their centres `distance` apart along x, as two closed shells that pass through each other:
/// 40 * frequency^2 triangles.
TriangleSoup overlapping_spheres(float radius, float distance, std::uint32_t frequency);

/// A lumpy rock: a sphere displaced along its radius by five octaves of seeded smooth noise, with the normals of the
/// displaced surface; radius 0.4 to 1.6. Star-shaped, so it never intersects itself.
///
/// The sphere is a box with na, nb, nc cells, as equal as the count allows: 4 * (na*nb + nb*nc + nc*na) triangles,
/// which is even and within 5 % of `triangles` from 100 to 16 million. Triangles come in a spatially coherent order and
/// vertices are numbered by first use. O(n).
TriangleSoup asteroid(std::uint64_t triangles, std::uint64_t seed);

/// The same triangles in a random order with randomly numbered vertices: a bad case for the caches of a linear cutter.
/// A soup with indices out of range, or with lists of the wrong length, comes back unchanged. O(n).
TriangleSoup shuffled(TriangleSoup soup, std::uint64_t seed);

/// Names that make() knows, sorted, for help texts and for tests over all shapes.
const std::vector<std::string>& names();

/// A shape by name with about `triangles` triangles (at least what the shape needs; the sponge takes the nearest
/// level). Only the asteroid uses the seed. Empty for an unknown name.
std::optional<TriangleSoup> make(std::string_view name, std::uint64_t triangles, std::uint64_t seed);

}  // namespace kerf::core::shapes
