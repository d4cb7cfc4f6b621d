#pragma once

#include <kerf/export.h>
#include <kerf/math.h>
#include <kerf/status.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace kerf {

/// @addtogroup meshes
/// From the arrays of a program, and back into arrays. What a back end relies on holds for every Mesh, because
/// Mesh::make() is the only way to one.
/// @{

/// No index: of a cap's triangle the source, for example.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Further numbers of each vertex: colours, tangents, anything. At a cut point they are found in proportion to the
/// distances from the ends of the edge. A value that is not finite is 0. Borrowed for the call.
struct StreamInput
{
    const char* name = "";          ///< UTF-8; PLY files have it, with _ for what is no letter or digit
    const float* values = nullptr;  ///< `width` for each vertex
    std::uint32_t width = 1;        ///< floats of a vertex, 1 to 16
    std::size_t stride = 0;         ///< bytes from vertex to vertex; 0: width * 4
};

/// How a material looks, for programs that draw or write files; a cut looks at none of it. One without a name gets one:
/// "surface", "material 2".
struct Material
{
    const char* name = "";  ///< UTF-8; may be empty
    /// Linear, with alpha. A number that is not finite is taken as 1.
    float base_colour[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    const char* base_colour_image = "";  ///< a file name, or "" for none
};

/// A mesh as a program holds it: plain arrays with any stride, borrowed for the call and only read. Vertices with the
/// same coordinates, bit for bit (-0 is 0), are one place of the surface, whatever their indices.
///
///     kerf::MeshInput input;
///     input.positions = &vertices[0].position.x;
///     input.position_stride = sizeof(vertices[0]);
///     input.vertex_count = vertices.size();
///     input.indices = triangles.data();
///     input.triangle_count = triangles.size() / 3;
struct MeshInput
{
    const float* positions = nullptr;        ///< three for each vertex, in the caller's unit of length
    std::size_t position_stride = 12;        ///< bytes from vertex to vertex, 12 at least
    std::size_t vertex_count = 0;            ///< below 2^32 - 1
    const std::uint32_t* indices = nullptr;  ///< three for each triangle, counter-clockwise seen from outside; null:
                                             ///< each three vertices are a triangle
    std::size_t triangle_count = 0;          ///< below 2^32 / 3
    const float* normals = nullptr;          ///< three for each vertex, of about length 1; null: smooth ones are made
    std::size_t normal_stride = 12;          ///< bytes from vertex to vertex, 12 at least
    float crease_degrees = 40.0f;            ///< if normals are made: edges that turn by more stay sharp; 0 to 180
    const float* uvs = nullptr;              ///< two for each vertex, origin in the lower left corner; null: all 0
    std::size_t uv_stride = 8;               ///< bytes from vertex to vertex, 8 at least
    const std::uint32_t* triangle_materials = nullptr;  ///< one for each triangle; null: all 0
    std::span<const Material> materials = {};           ///< empty: one without a name
    std::span<const StreamInput> streams = {};          ///< further numbers of each vertex
};

/// What was wrong with a mesh, and what was done about it. Nothing of it moves a vertex.
struct Repairs
{
    std::uint64_t degenerate_triangles = 0;  ///< dropped: two corners at one place
    std::uint64_t duplicate_triangles = 0;   ///< dropped: there twice, and needed once
    std::uint64_t coinciding_triangles = 0;  ///< kept: there twice, and needed twice
    std::uint64_t nonmanifold_edges = 0;     ///< more than two triangles met there: divided
    std::uint64_t nonmanifold_points = 0;    ///< several parts of the surface met in a point: divided
    std::uint64_t flipped_triangles = 0;     ///< turned over to agree with the rest, or with the outside
    std::uint64_t unorientable_edges = 0;    ///< cut open: a Moebius strip has no outside
    std::uint64_t replaced_attributes = 0;   ///< vertices with a normal or a uv that is not finite

    friend bool operator==(const Repairs&, const Repairs&) = default;
};

/// One clause for each kind of repair that occurred, for people: "3 degenerate triangles dropped, 2 points split";
/// empty if nothing was repaired.
KERF_API Sentence describe(const Repairs& repairs) noexcept;

/// Facts of a mesh as it was given.
struct MeshFacts
{
    std::uint64_t triangles = 0;             ///< all that were given
    std::uint64_t vertices = 0;              ///< all that were given
    std::uint64_t points = 0;                ///< places: vertices that are welded count once
    std::uint64_t degenerate_triangles = 0;  ///< two corners at one place
    std::uint64_t duplicate_triangles = 0;   ///< the same three places as an earlier one, in the same orientation
    std::uint64_t boundary_edges = 0;        ///< edges with one triangle
    std::uint64_t boundary_loops = 0;        ///< connected parts of the boundary: holes
    std::uint64_t open_edges = 0;            ///< those that are left once the mesh is repaired
    std::uint64_t nonmanifold_edges = 0;     ///< edges with more than two triangles
    std::uint64_t nonmanifold_points = 0;    ///< points where several parts of the surface meet
    std::uint64_t misoriented_edges = 0;     ///< edges whose two triangles run along them in one direction
    std::uint64_t unbalanced_edges = 0;      ///< edges along which more triangles run one way than the other
    std::uint64_t shells = 0;                ///< parts that are connected by edges
    double shortest_edge = 0.0;              ///< in the mesh's unit; infinite without edges
    double area = 0.0;                       ///< of the surface, in its square
    double volume = 0.0;                     ///< signed, in its cube; of a closed mesh, or about the origin
    Box bounds = {};                         ///< of all vertices
    bool has_coarse_coordinates = false;     ///< see Mesh::has_coarse_coordinates()

    /// Whether the repaired mesh bounds solids: it has no holes.
    bool is_closed() const noexcept { return open_edges == 0; }
    /// Whether each edge has at most two triangles, and each point one part of the surface around it.
    bool is_manifold() const noexcept { return nonmanifold_edges == 0 && nonmanifold_points == 0; }
    /// Whether neighbours agree on which side is outside.
    bool is_oriented() const noexcept { return misoriented_edges == 0; }
};

/// Where a triangle comes from.
enum class TriangleKind : unsigned char
{
    surface = 0,  ///< from the mesh that was given, or a part of a triangle of it
    cap = 1,      ///< closes a section
};

/// The arrays of a mesh. They belong to the mesh and live as long as it or a copy of it.
struct MeshArrays
{
    std::span<const Vec3f> positions;                   ///< for each vertex
    std::span<const Vec3f> normals;                     ///< for each vertex, of length 1
    std::span<const Vec2f> uvs;                         ///< for each vertex
    std::span<const std::uint32_t> points;              ///< for each vertex the place on the surface that it is at
    std::uint32_t point_count = 0;                      ///< how many places there are
    std::span<const std::uint32_t> indices;             ///< three for each triangle
    std::span<const std::uint32_t> sources;             ///< for each triangle that of the input; kNone of a cap
    std::span<const TriangleKind> kinds;                ///< for each triangle
    std::span<const std::uint32_t> triangle_materials;  ///< for each triangle
    std::span<const std::uint32_t> solids;              ///< for each triangle the body that it bounds
};

/// A stream of a mesh.
struct Stream
{
    const char* name = "";          ///< as StreamInput has it
    std::uint32_t width = 1;        ///< floats of a vertex
    std::span<const float> values;  ///< `width` for each vertex
};

/// What make() says beside the mesh.
struct MeshReport
{
    MeshFacts facts;  ///< of what was given
    Repairs repairs;  ///< what was done about it
};

/// A mesh that can be cut. It can't be changed, and copies share it: they cost O(1). An empty one has no triangles;
/// every call answers a status to it. Const members may be called from any threads.
class KERF_API Mesh
{
public:
    /// An empty one, or another name for the same mesh; what is moved from is empty.
    /// @{
    Mesh() noexcept = default;
    Mesh(const Mesh& other) noexcept;
    Mesh(Mesh&& other) noexcept;
    Mesh& operator=(Mesh other) noexcept;
    /// @}
    ~Mesh();

    /// Makes a mesh of arrays, and repairs it: vertices of one place are welded, triangles that can't be are dropped,
    /// edges of more than two triangles divided, shells turned the right side out. Each change is counted, and none
    /// moves a vertex.
    ///
    /// O(n log n) for n triangles. Status: `invalid_mesh` with a sentence that names the first fault (an index out of
    /// range, a coordinate that is not finite, no triangle), `out_of_memory`.
    ///
    /// @param report  receives facts and repairs, also if there is no mesh (as far as they are known); may be null
    static Result<Mesh> make(const MeshInput& input, MeshReport* report = nullptr) noexcept;

    bool is_empty() const noexcept { return data_ == nullptr; }  ///< whether there is no triangle
    /// A copy that shares nothing, for prepare() to keep while this one stays: a copy of memory, not a make(). O(n).
    /// Status: `out_of_memory`, `invalid_mesh` for an empty mesh.
    Result<Mesh> clone() const noexcept;

    std::uint64_t triangle_count() const noexcept;  ///< 0 of an empty mesh. O(1).
    std::uint64_t vertex_count() const noexcept;    ///< a place with a seam has several. O(1).
    /// Whether the surface has no boundary, so that it bounds solids. O(1); O(n) of an object's mesh.
    bool is_closed() const noexcept;
    /// A warning: the shortest edge is so short, and the mesh so far from the origin or so large, that rounding to
    /// float moves cut points by a considerable part of it. Cuts are closed all the same. O(1); O(n) of an
    /// object's mesh.
    bool has_coarse_coordinates() const noexcept;
    Box bounds() const noexcept;  ///< of all vertices; empty of an empty mesh. O(1); O(n) of an object's mesh.

    /// The arrays, made at the first call for each mesh: O(n) then and if memory runs out all of them are empty; O(1)
    /// afterwards.
    MeshArrays arrays() const noexcept;
    std::size_t stream_count() const noexcept;        ///< of stream()
    Stream stream(std::size_t i) const noexcept;      ///< an empty one if there is none of that number
    std::size_t material_count() const noexcept;      ///< of material()
    Material material(std::size_t i) const noexcept;  ///< one without a name if there is none of that number

    /// @cond For the library itself.
    class Data;
    explicit Mesh(Data* data) noexcept : data_(data) {}
    Data* data() const noexcept { return data_; }
    /// @endcond

private:
    Data* data_ = nullptr;
};

/// What to tell a user of a mesh with has_coarse_coordinates(): one sentence.
inline constexpr const char* kCoarseCoordinatesText =
    "coarse coordinates: the shortest edge is under 16 steps of the coordinates' precision; move the mesh towards the "
    "origin before it is stored in single precision";

/// How a vertex came to be: the sum of three vertices of the input, each times its weight. The weights are 0 to 1 and
/// add up to 1. A vertex of the input itself has one weight of 1; a point where an edge was cut has two that are not 0,
/// unless the edge was made by a cut before; then it lies inside a triangle and has three.
struct VertexOrigin
{
    std::uint32_t vertices[3] = {kNone, kNone, kNone};  ///< kNone: a vertex of a cap
    float weights[3] = {0.0f, 0.0f, 0.0f};              ///< one for each of them
};

/// For each vertex of `mesh`, which was made of `input` or cut out of what was: where it lies in the input. Weights
/// are exact for vertices of the input, otherwise rounded. For attributes that Kerf knows nothing of. O(n). (The
/// weights are those of the nearest point in the source triangle: Ericson, "Real-Time Collision Detection", 5.1.5.)
///
/// @param origins  one for each vertex of `mesh`
/// @return  `invalid_argument`, with nothing written, if there are fewer or more, or if `input` has no triangle that
///          the mesh was made of, or strides that Mesh::make() refuses
KERF_API Status vertex_origins(const Mesh& mesh, const MeshInput& input, std::span<VertexOrigin> origins) noexcept;

/// @}

}  // namespace kerf
