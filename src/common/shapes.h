#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/assemble.h"

// Generated shapes: the shared fixtures of tests, benchmarks and viewer. Closed, consistently oriented, with normals
// and uv; all centred on the origin unless said otherwise. Give them to assemble().

namespace kerf::shapes {

/// Sphere from an icosahedron whose faces are divided into frequency^2 triangles: 20 * frequency^2 triangles.
TriangleSoup icosphere(float radius, std::uint32_t frequency);

/// Sphere in rings and slices around z, uv seam and poles included: 2 * slices * (rings - 1) triangles.
TriangleSoup uv_sphere(float radius, std::uint32_t slices, std::uint32_t rings);

/// Box with each face divided into a grid of n.x, n.y, n.z cells: 4 * (nx*ny + ny*nz + nz*nx) triangles, sharp edges.
TriangleSoup box(const glm::vec3& size, const glm::uvec3& cells);

/// Cylinder around z with flat ends (fans): 4 * slices triangles for one stack.
TriangleSoup cylinder(float radius, float height, std::uint32_t slices, std::uint32_t stacks = 1);

/// Cone around z, apex up: 2 * slices triangles.
TriangleSoup cone(float radius, float height, std::uint32_t slices);

/// Torus around z: 2 * major * minor triangles.
TriangleSoup torus(float major_radius, float minor_radius, std::uint32_t major, std::uint32_t minor);

/// Tube around z, open through the middle but closed as a surface: an annulus at both ends. 8 * slices triangles for
/// one stack.
TriangleSoup pipe(float outer_radius, float inner_radius, float height, std::uint32_t slices, std::uint32_t stacks = 1);

/// A bar along x with `teeth` teeth along +y: a plane across the teeth gives one loop for each.
TriangleSoup comb(std::uint32_t teeth);

/// A wall of constant thickness that winds `turns` times around z: a plane across z gives one long concave loop.
TriangleSoup spiral_wall(float turns, std::uint32_t segments_per_turn);

/// Menger sponge of side 1, `level` 0 to 4: all faces on the lattice of the smallest cubes, closed and manifold.
TriangleSoup menger_sponge(std::uint32_t level);

/// A sphere with a concentric spherical cavity (an inner shell that is inside out).
TriangleSoup sphere_in_sphere(float outer_radius, float inner_radius, std::uint32_t frequency);

/// A lumpy rock: a sphere displaced along its radius by a few octaves of seeded smooth noise; radius about 1.
/// Star-shaped, so it never intersects itself. `triangles` from 100 to 16 million is met within 5 %; even sizes only.
/// Triangles come in a spatially coherent order.
TriangleSoup asteroid(std::uint64_t triangles, std::uint64_t seed);

/// The same triangles in a random order with randomly numbered vertices: what a linear cutter's caches dislike.
TriangleSoup shuffled(TriangleSoup soup, std::uint64_t seed);

/// Names that make() knows, for help texts and for tests over all shapes.
const std::vector<std::string>& names();

/// A shape by name with about `triangles` triangles (at least what the shape needs). Empty for an unknown name.
std::optional<TriangleSoup> make(std::string_view name, std::uint64_t triangles, std::uint64_t seed);

}  // namespace kerf::shapes
