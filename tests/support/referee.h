#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/cutting/cut.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"

// Judges of cut results. They read positions, indices and ids, and share no code with what they judge.

namespace kerf::core::referee {

/// What IndexedMesh promises about sizes, indices, ids, groups and numbers, promise by promise as its comment has them.
bool is_well_formed(const IndexedMesh& mesh);

/// Directed edges, by point id, that do not occur as often as their reverse. 0 for a closed mesh.
std::size_t open_edges(const IndexedMesh& mesh);

/// The same by bit-equal positions: what a user who welds an exported file sees.
std::size_t open_edges_by_position(const IndexedMesh& mesh);

/// Triangles two corners of which are at one position.
std::size_t triangles_with_equal_corners(const IndexedMesh& mesh);

/// Volumes and areas of the parts add up to the whole's within this share of it.
inline constexpr double kSumTolerance = 1e-6;

/// Sum of the signed tetrahedra over the first vertex, in long double.
double volume(const IndexedMesh& mesh);
/// Of all fragments together.
double volume(const std::vector<std::unique_ptr<Cuttable>>& fragments);

/// Sum of triangle areas of one kind, or of all.
double area(const IndexedMesh& mesh);
double area(const IndexedMesh& mesh, TriangleKind kind);

/// Largest distance, in mesh units, that a vertex of the mesh lies on the wrong side of the plane; 0 or less when none
/// does.
double overhang(const IndexedMesh& mesh, const Plane& plane, bool positive_side);

/// Area of the caps in the plane with this unit normal, each triangle counted positive.
double cap_area_in_plane(const IndexedMesh& mesh, const glm::dvec3& normal);

/// Area of the plane with this unit normal that closed loops wind around, counted as often as they do, backwards or
/// not: what caps cannot help covering. By strips between all ends and crossings of edges, O(k^3 log k).
double wound_area(std::span<const SectionLoop> loops, const glm::dvec3& normal);

/// Parts connected by shared edges (point ids).
std::size_t edge_components(const IndexedMesh& mesh);

/// One surface triangle as comparable numbers: source, material name, and the bits of its corners' attributes and
/// streams, beginning with the smallest corner.
struct SurfaceTriangle
{
    std::uint32_t source;
    std::string material;
    std::vector<std::uint32_t> bits;

    auto operator<=>(const SurfaceTriangle&) const = default;
};

/// All surface triangles, sorted: equal vectors mean equal multisets.
std::vector<SurfaceTriangle> canonical_surface(const IndexedMesh& mesh);

/// The bytes of everything in the mesh, for "same bytes on every run".
std::vector<std::uint32_t> bytes_of(const IndexedMesh& mesh);

/// Joins meshes into one, side by side, for sums over the pieces of a side.
std::vector<SurfaceTriangle> canonical_surface(const std::vector<std::unique_ptr<Cuttable>>& fragments);
/// The surface of each fragment, in order: what a side fell into, whichever came first.
std::vector<std::vector<SurfaceTriangle>> canonical_pieces(const std::vector<std::unique_ptr<Cuttable>>& fragments);

}  // namespace kerf::core::referee
