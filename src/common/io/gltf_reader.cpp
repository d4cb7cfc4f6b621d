#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/io/gltf_accessors.h"
#include "common/io/gltf_document.h"
#include "common/io/gltf_extensions.h"
#include "common/io/gltf_materials.h"
#include "common/io/gltf_scene.h"
#include "common/io/mesh_file.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/mesh/is_finite.h"

// Reads the meshes that the scene of a glTF file shows, and nothing else of it. Transforms are applied in double; a
// mesh without one keeps its coordinates bit for bit.

namespace kerf::core::io {

namespace {

/// Modes of primitives that are triangles; smaller numbers are points and lines.
constexpr std::uint64_t kTriangles = 4, kFan = 6;

/// TEXCOORD_0 is the vertices' uv; the others, if there are any, become streams.
constexpr std::size_t kMostUvSets = 8;

/// Every node copies the vertices of its mesh, and accessors may be zeros without bytes in the file: this many times
/// the file's own size are allowed, so that a small file cannot ask for all memory.
constexpr std::uint64_t kMostCopies = 64, kCopiesAllowed = 1 << 20;

/// More work than any file may ask for, and small enough that sums of it don't overflow.
constexpr std::uint64_t kUnbounded = std::uint64_t{1} << 60;

/// A checked primitive of triangles. Its attributes may be shorter than its positions.
struct Primitive
{
    std::uint64_t mode = kTriangles, corners = 0;
    const GltfAccessor* positions = nullptr;
    const GltfAccessor* indices = nullptr;
    const GltfAccessor* normals = nullptr;
    const GltfAccessor* colours = nullptr;
    std::array<const GltfAccessor*, kMostUvSets> uvs{};
    std::uint32_t material = 0;
};

struct Mesh
{
    std::vector<Primitive> primitives;
    std::uint64_t work = 0;  ///< vertices and corners
};

class GltfReader
{
public:
    GltfReader(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
        : path_(path),
          notes_(notes),
          size_(bytes.size()),
          document_(path, bytes, notes),
          extensions_(document_),
          accessors_(document_, extensions_),
          materials_(gltf_materials(document_)),
          builder_(path, notes)
    {
    }

    TriangleSoup read()
    {
        const std::vector<GltfPlacement> placements = placements_of(document_, accessors_);
        for (const GltfPlacement& placement : placements)
            if (!meshes_.contains(placement.mesh)) meshes_.emplace(placement.mesh, check_mesh(placement.mesh));
        check_work(placements);
        for (const GltfMaterial& material : materials_) builder_.soup.materials.push_back(material.material);
        plan_streams();
        for (const GltfPlacement& placement : placements) add_placement(placement);
        return builder_.finish();
    }

private:
    Mesh check_mesh(std::uint64_t number)
    {
        const std::string where = "mesh " + std::to_string(number);
        Mesh mesh;
        const GltfJson& source = document_.element("meshes", number, "mesh", "a node");
        extensions_.check(source, where);
        const GltfJson& primitives = document_.list(source, "primitives", where);
        if (primitives.empty()) notes_.add("meshes without primitives passed over");
        for (const GltfJson& primitive : primitives) check_primitive(primitive, where, mesh);
        return mesh;
    }

    /// Adds a primitive to the mesh if it consists of triangles.
    void check_primitive(const GltfJson& source, const std::string& where, Mesh& mesh)
    {
        if (!source.is_object()) document_.refuse("a primitive of " + where + " is not an object");
        Primitive p;
        p.mode = document_.number_if(source, "mode", where).value_or(kTriangles);
        if (p.mode > kFan) document_.refuse("a primitive of " + where + " has a mode that glTF does not know");
        if (p.mode < kTriangles) return notes_.add("primitives of points or lines passed over");
        const GltfJson* attributes = document_.object_if(source, "attributes");
        const auto position = attributes != nullptr ? document_.index_if(*attributes, "POSITION", where) : std::nullopt;
        const bool is_compressed = document_.extension(source, "KHR_draco_mesh_compression") != nullptr;
        if (!position && !is_compressed) return notes_.add("primitives without positions passed over");
        extensions_.check(source, "a primitive of " + where);
        if (position) p.positions = &accessors_.at(*position, where);
        if (is_compressed) find_copy(source, where, p);
        if (p.positions->width != 3) document_.refuse("the positions of " + where + " are not three numbers each");
        if (p.positions->component == GltfComponent::uint32)
            notes_.add("lists of positions that are 32-bit integers, which no version of glTF allows");
        p.corners = check_indices(source, where, p);
        if (p.mode == kTriangles && p.corners % 3 != 0) {
            notes_.add("corners behind the last whole triangle passed over", p.corners % 3);
            p.corners -= p.corners % 3;
        }
        find_decoration(*attributes, where, p);
        p.material = material_of(source, where);
        mesh.work = std::min(mesh.work + p.positions->count + p.corners, kUnbounded);
        mesh.primitives.push_back(p);
    }

    /// A compressed primitive is read if its accessors have data of their own.
    void find_copy(const GltfJson& source, const std::string& where, const Primitive& p)
    {
        const auto index = document_.index_if(source, "indices", where);
        if (p.positions == nullptr || !p.positions->has_data() || (index && !accessors_.at(*index, where).has_data()))
            document_.refuse("a primitive of " + where +
                             " is compressed by KHR_draco_mesh_compression, which is not "
                             "supported, and there is no uncompressed copy of it; export it without compression");
        notes_.add("primitives with compressed data read from their uncompressed copies");
    }

    /// Finds the indices, if there are any, and returns the number of corners.
    std::uint64_t check_indices(const GltfJson& source, const std::string& where, Primitive& p)
    {
        const auto index = document_.index_if(source, "indices", where);
        if (!index) return p.positions->count;
        p.indices = &accessors_.at(*index, where);
        if (p.indices->width != 1) document_.refuse("the indices of " + where + " are not one number each");
        const bool is_allowed = p.indices->component == GltfComponent::uint8 ||
                                p.indices->component == GltfComponent::uint16 ||
                                p.indices->component == GltfComponent::uint32;
        if (!is_allowed) notes_.add("lists of indices that are no unsigned integers taken by their values");
        return p.indices->count;
    }

    /// Attributes that do not matter for the surface: one that cannot be used is left out.
    void find_decoration(const GltfJson& attributes, const std::string& where, Primitive& p)
    {
        p.normals = decoration(attributes, "NORMAL", 3, 3, p, where);
        p.colours = decoration(attributes, "COLOR_0", 1, 4, p, where);
        for (std::size_t k = 0; k < kMostUvSets; ++k)
            p.uvs[k] = decoration(attributes, "TEXCOORD_" + std::to_string(k), 2, 4, p, where);
    }

    const GltfAccessor* decoration(const GltfJson& attributes, const std::string& name, std::uint64_t narrowest,
                                   std::uint64_t widest, const Primitive& p, const std::string& where)
    {
        if (!attributes.contains(name)) return nullptr;
        const GltfAccessor* accessor = nullptr;
        try {
            if (const auto index = document_.index_if(attributes, name.c_str(), where))
                accessor = &accessors_.at(*index, where);
        } catch (const FileError&) {
            notes_.add("lists of '" + name + "' that cannot be read passed over");
        }
        if (accessor == nullptr) return nullptr;
        if (accessor->width < narrowest || accessor->width > widest) {
            notes_.add("lists of '" + name + "' of another shape passed over");
            return nullptr;
        }
        if (accessor->count < p.positions->count)
            notes_.add("values of '" + name + "' that are missing given a default",
                       p.positions->count - accessor->count);
        if (accessor->count > p.positions->count)
            notes_.add("values of '" + name + "' of no vertex passed over", accessor->count - p.positions->count);
        return accessor;
    }

    /// Primitives without a material share one without a name, which follows the others.
    std::uint32_t material_of(const GltfJson& source, const std::string& where) const
    {
        const auto none = static_cast<std::uint32_t>(materials_.size());
        try {
            const auto index = document_.index_if(source, "material", where);
            if (!index) return none;
            if (*index < materials_.size()) return static_cast<std::uint32_t>(*index);
        } catch (const FileError&) {
            // A value that is no number names no material either.
        }
        notes_.add("materials that are not there taken as none");
        return none;
    }

    /// Checks the work that the file asks for against its size before anything is copied.
    void check_work(const std::vector<GltfPlacement>& placements) const
    {
        const std::uint64_t most = std::max(kCopiesAllowed, kMostCopies * (size_ + accessors_.bytes_beside()));
        std::uint64_t left = most;
        for (const GltfPlacement& placement : placements) {
            const std::uint64_t work = meshes_.at(placement.mesh).work + 1;
            if (work > most)
                document_.refuse("mesh " + std::to_string(placement.mesh) + " asks for more than " +
                                 std::to_string(most) + " vertices and corners, too many for a file of its size");
            if (placement.instances.count > left / work)
                document_.refuse("it asks for more than " + std::to_string(most) +
                                 " vertices and corners, too many for a file of its size; export fewer copies");
            left -= placement.instances.count * work;
        }
    }

    /// One stream for each attribute that some mesh of the scene has; others get white and 0.
    void plan_streams()
    {
        for (const auto& [number, mesh] : meshes_)
            for (const Primitive& p : mesh.primitives) {
                has_colour_ = has_colour_ || p.colours != nullptr;
                for (std::size_t k = 1; k < kMostUvSets; ++k)
                    if (p.uvs[k] != nullptr) uv_sets_ = std::max(uv_sets_, k + 1);
            }
        if (has_colour_) builder_.soup.streams.push_back({"color", 4, {}});
        for (std::size_t k = 1; k < uv_sets_; ++k) builder_.soup.streams.push_back({"uv" + std::to_string(k), 2, {}});
    }

    void add_placement(const GltfPlacement& placement)
    {
        const std::string where = "mesh " + std::to_string(placement.mesh);
        const bool is_instanced = placement.instances.translation != nullptr ||
                                  placement.instances.rotation != nullptr || placement.instances.scale != nullptr;
        for (std::uint64_t i = 0; i < placement.instances.count; ++i) {
            const glm::dmat4 transform =
                is_instanced ? placement.transform * placement.instances.transform(i) : placement.transform;
            for (const Primitive& p : meshes_.at(placement.mesh).primitives) add_primitive(p, where, transform);
        }
    }

    void add_primitive(const Primitive& p, const std::string& where, const glm::dmat4& transform)
    {
        find_corners(p, where);
        const std::vector<std::uint32_t> index = add_vertices(p, transform);
        if (p.material == builder_.soup.materials.size()) builder_.soup.materials.emplace_back();
        builder_.use_material(p.material);
        // A transform that mirrors turns triangles inside out.
        const bool mirrored = glm::determinant(glm::dmat3(transform)) < 0.0;
        const std::uint64_t n = corners_.size();
        const auto add = [&](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
            if (mirrored) std::swap(a, c);
            const std::array<std::uint32_t, 3> triangle{index[corners_[a]], index[corners_[b]], index[corners_[c]]};
            builder_.add_face(triangle);
        };
        if (p.mode == kTriangles)
            for (std::uint64_t i = 0; i < n; i += 3) add(i, i + 1, i + 2);
        else
            for (std::uint64_t i = 0; i + 2 < n; ++i)
                p.mode == kFan ? add(0, i + 1, i + 2) : add(i, i + 1 + i % 2, i + 2 - i % 2);
    }

    /// Fills `corners_`: the vertex of the primitive at each corner, in range.
    void find_corners(const Primitive& p, const std::string& where)
    {
        if (p.corners > std::numeric_limits<std::uint32_t>::max())
            fail(path_, where + " has more than 2^32 corners; divide it into several");
        const std::uint64_t vertices = p.positions->count;
        corners_.clear();
        corners_.reserve(p.corners);
        for (std::uint64_t i = 0; i < p.corners; ++i) {
            const double vertex = p.indices != nullptr ? p.indices->stored(i, 0) : static_cast<double>(i);
            if (!(vertex >= 0.0 && vertex < static_cast<double>(vertices)) || std::floor(vertex) != vertex)
                fail(path_, "corner " + std::to_string(i) + " of " + where + " names vertex " + text_of(vertex) +
                                ", but there are only " + std::to_string(vertices) +
                                ", counted from 0; export it again");
            corners_.push_back(static_cast<std::uint32_t>(vertex));
        }
    }

    /// A number for a message: whole ones without a fraction.
    static std::string text_of(double number)
    {
        const bool is_whole = std::abs(number) < 1e15 && std::floor(number) == number;
        return is_whole ? std::to_string(static_cast<std::int64_t>(number)) : std::to_string(number);
    }

    /// Adds the vertices that corners use (primitives may share one long list) and returns their indices.
    std::vector<std::uint32_t> add_vertices(const Primitive& p, const glm::dmat4& transform)
    {
        constexpr std::uint32_t kUnused = 0xFFFFFFFFu;
        std::vector<std::uint32_t> index(p.positions->count, kUnused);
        for (const std::uint32_t corner : corners_) index[corner] = 0;
        const bool is_first = looked_through_.insert(p.positions).second;
        const bool moved = transform != glm::dmat4(1.0);
        // Normals follow the inverse transpose; up to its length, which is restored later, that is the cofactor matrix.
        const glm::dmat3 linear(transform);
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
        for (std::uint64_t i = 0; i < p.positions->count; ++i) {
            if (index[i] == kUnused) {
                // If another primitive uses it, the file is refused.
                if (is_first && !is_finite(vector_at(*p.positions, i))) notes_.add(kUnusedVertices);
                continue;
            }
            Vertex v{{}, kNoNormal, {}};
            const glm::dvec3 place = vector_at(*p.positions, i);
            v.position = glm::vec3(moved ? glm::dvec3(transform * glm::dvec4(place, 1.0)) : place);
            if (p.normals != nullptr && i < p.normals->count) {
                const glm::dvec3 n = vector_at(*p.normals, i);
                v.normal = moved ? unit(side * (cofactors * n)) : glm::vec3(n);
            }
            v.uv = uv_at(p, 0, i);
            index[i] = builder_.add_vertex(v);
            add_streams(p, i);
        }
        return index;
    }

    static glm::dvec3 vector_at(const GltfAccessor& accessor, std::uint64_t i)
    {
        return {accessor.value(i, 0), accessor.value(i, 1), accessor.value(i, 2)};
    }

    /// NaN stays NaN: whether it matters is decided for all formats in one place.
    static glm::vec3 unit(const glm::dvec3& n)
    {
        const double length = std::hypot(n.x, n.y, n.z);
        return length == 0.0 ? kNoNormal : glm::vec3(n / length);
    }

    /// Texture coordinates as the material's texture uses them. glTF's origin is the upper left corner.
    glm::vec2 uv_at(const Primitive& p, std::size_t set, std::uint64_t i) const
    {
        const GltfAccessor* uvs = p.uvs[set];
        if (uvs == nullptr || i >= uvs->count) return {};
        glm::dvec2 uv(uvs->value(i, 0), uvs->value(i, 1));
        if (p.material < materials_.size()) {
            const GltfMaterial& material = materials_[p.material];
            if (material.uv_set == set && material.moves_texture()) uv = material.place(uv);
        }
        return {static_cast<float>(uv.x), 1.0f - static_cast<float>(uv.y)};
    }

    /// One number is grey, three are opaque.
    static glm::vec4 colour_at(const GltfAccessor& colours, std::uint64_t i)
    {
        glm::vec4 colour(1.0f);
        for (std::uint64_t k = 0; k < colours.width; ++k)
            colour[static_cast<int>(k)] = static_cast<float>(colours.fraction(i, k));
        if (colours.width == 1) colour.y = colour.z = colour.x;
        if (colours.width == 2) colour = {colour.x, colour.x, colour.x, colour.y};
        return colour;
    }

    void add_streams(const Primitive& p, std::uint64_t i)
    {
        auto stream = builder_.soup.streams.begin();
        if (has_colour_) {
            const bool is_given = p.colours != nullptr && i < p.colours->count;
            const glm::vec4 colour = is_given ? colour_at(*p.colours, i) : glm::vec4(1.0f);
            for (int k = 0; k < 4; ++k) stream->values.push_back(colour[k]);
            ++stream;
        }
        for (std::size_t k = 1; k < uv_sets_; ++k, ++stream) {
            const glm::vec2 place = uv_at(p, k, i);
            stream->values.push_back(place.x);
            stream->values.push_back(place.y);
        }
    }

    const std::filesystem::path& path_;
    ReadingNotes& notes_;
    std::uint64_t size_;
    GltfDocument document_;
    GltfExtensions extensions_;
    GltfAccessors accessors_;
    std::vector<GltfMaterial> materials_;
    std::map<std::uint64_t, Mesh> meshes_;  ///< those that the scene shows
    SoupBuilder builder_;
    std::set<const GltfAccessor*> looked_through_;  ///< lists of positions
    bool has_colour_ = false;
    std::size_t uv_sets_ = 1;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

TriangleSoup read_gltf(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    return GltfReader(path, bytes, notes).read();
}

}  // namespace kerf::core::io
