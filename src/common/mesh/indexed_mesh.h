#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "common/mesh/box.h"
#include "common/mesh/buffer.h"

// The mesh: vertices with attributes, triangles in groups, points that say which vertices are one.

namespace kerf::core {

/// What the GPU reads for one corner: 32 bytes, interleaved.
struct Vertex
{
    glm::vec3 position;
    glm::vec3 normal;  ///< unit length
    glm::vec2 uv;
};
static_assert(sizeof(Vertex) == 32);

/// Three vertex indices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

enum class TriangleKind : std::uint8_t
{
    surface,  ///< part of the loaded mesh, or cut out of it
    cap,      ///< closes the section of a cut; stays cap through later cuts
};

/// `source` of a triangle that comes from no input triangle: a cap triangle.
inline constexpr std::uint32_t kNoSource = std::numeric_limits<std::uint32_t>::max();

/// A run of triangles that share their material, solid and kind.
struct TriangleGroup
{
    std::uint32_t first = 0;     ///< first triangle of the run
    std::uint32_t count = 0;     ///< number of triangles
    std::uint32_t material = 0;  ///< index into IndexedMesh::materials
    std::uint32_t solid = 0;     ///< which solid of the loaded mesh: an outer shell with its cavities
    TriangleKind kind = TriangleKind::surface;
};

/// How a surface looks, as far as mesh files say.
struct Material
{
    std::string name;
    glm::vec4 colour{1.0f};  ///< linear rgb and alpha
    std::string texture;     ///< path of a colour texture as the file names it; empty for none
};

/// Floats that accompany the vertices (a colour, a tangent, anything); cuts interpolate them.
struct VertexStream
{
    std::string name;
    std::uint32_t width = 1;  ///< floats per vertex
    Buffer<float> values;     ///< width * vertices
};

/// An indexed triangle mesh that a back end can cut. `repair()` (common/repair/repair.h) makes one out of any triangles
/// and establishes the promises below; `prove()` (common/repair/proven_mesh.h) checks them, for meshes made by hand. A
/// mesh that breaks a promise is refused with one sentence.
///
/// * There is a triangle; at most 2^32 / 3 triangles and fewer than 2^32 - 1 vertices; each vertex has a point and is a
///   corner of a triangle; each triangle has a source.
/// * `points` gives each vertex its point, a place on the surface: vertices at a seam differ in normal or uv and share
///   a point. Connectivity is by point. Point ids are dense: every id below `point_count` is used. All vertices of a
///   point have equal positions. (Equal positions do not mean equal points: touching corners stay apart.)
/// * No triangle has two corners at one position.
/// * No directed edge (by point) occurs twice. The triangles around a point form one vertex fan.
/// * `groups` cover the triangles in order, without gap or overlap, and name materials and kinds that exist.
///   Several may be alike, or empty. Triangles that share an edge are in groups of one solid.
/// * Coordinates are finite, however large; -0 does not occur. Normals and uv are finite.
/// * Streams have `width` >= 1 values for each vertex.
///
/// Nothing else is promised: `source` and `solid` may be any number, normals may have any length (cuts make unit ones),
/// streams may hold NaN and infinity (and give NaN next to them), materials need no name, triangles may have no area or
/// overlap.
struct IndexedMesh
{
    Buffer<Vertex> vertices;
    Buffer<std::uint32_t> points;   ///< point id of each vertex
    std::uint32_t point_count = 0;  ///< number of different point ids
    Buffer<Triangle> triangles;
    Buffer<std::uint32_t> sources;  ///< for each triangle the input triangle it was cut from, or kNoSource
    std::vector<TriangleGroup> groups;
    std::vector<VertexStream> streams;
    std::vector<Material> materials;

    /// Smallest box around all vertices. O(n).
    Box bounds() const
    {
        Box box;
        for (const Vertex& v : vertices) box.add(v.position);
        return box;
    }
};

/// Whether all corners are below `vertex_count`. O(n).
bool are_in_range(std::span<const Triangle> triangles, std::size_t vertex_count);

/// Checks what IndexedMesh promises about sizes, indices, ids, groups and numbers. Takes any mesh. Returns an empty
/// string, or one sentence that names the first fault. It does not look at how triangles meet at edges and points:
/// prove() does. O(n).
std::string check(const IndexedMesh& mesh);

}  // namespace kerf::core
