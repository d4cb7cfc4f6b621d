#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/gltf_document.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"

// Follows a checked glTF document: nodes, meshes, primitives, accessors. Transforms are applied in double; a mesh
// without one keeps its coordinates bit for bit.

namespace kerf::io {

namespace {

/// TEXCOORD_0 is the vertices' uv; the others, if there are any, become streams.
constexpr std::uint32_t kMostUvSets = 8;

/// A component of an element as a number; integers as they are.
double component(const char* place, GltfComponent type)
{
    switch (type) {
        case GltfComponent::int8:
            return load<std::int8_t>(place, Endian::little);
        case GltfComponent::uint8:
            return load<std::uint8_t>(place, Endian::little);
        case GltfComponent::int16:
            return load<std::int16_t>(place, Endian::little);
        case GltfComponent::uint16:
            return load<std::uint16_t>(place, Endian::little);
        case GltfComponent::uint32:
            return load<std::uint32_t>(place, Endian::little);
        case GltfComponent::float32:
            return static_cast<double>(load<float>(place, Endian::little));
    }
    return 0.0;
}

std::size_t size_of(GltfComponent type)
{
    if (type == GltfComponent::int8 || type == GltfComponent::uint8) return 1;
    return type == GltfComponent::int16 || type == GltfComponent::uint16 ? 2 : 4;
}

std::uint32_t index_at(const GltfAccessor& accessor, std::uint64_t i)
{
    return static_cast<std::uint32_t>(component(accessor.first + i * accessor.stride, accessor.component));
}

/// Element i; unsigned integers are fractions of their largest value. What the element does not have is 1.
glm::vec4 value_at(const GltfAccessor& accessor, std::uint64_t i)
{
    glm::vec4 value(1.0f);
    const double one = accessor.component == GltfComponent::uint8    ? 255.0
                       : accessor.component == GltfComponent::uint16 ? 65535.0
                                                                     : 1.0;
    for (std::uint64_t k = 0; k < accessor.width && k < 4; ++k) {
        const char* place = accessor.first + i * accessor.stride + k * size_of(accessor.component);
        value[static_cast<int>(k)] = static_cast<float>(component(place, accessor.component) / one);
    }
    return value;
}

/// Numbers of a node that check_gltf() has counted.
template <std::size_t N>
bool numbers_of(const GltfJson& node, const char* name, std::array<double, N>& numbers)
{
    const auto found = node.find(name);
    if (found == node.end()) return false;
    for (std::size_t i = 0; i < N; ++i) numbers[i] = (*found)[i].get<double>();
    return true;
}

glm::dmat4 transform_of(const GltfJson& node)
{
    std::array<double, 16> m;
    glm::dmat4 matrix(1.0);
    if (numbers_of(node, "matrix", m)) {
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) matrix[column][row] = m[static_cast<std::size_t>(4 * column + row)];
        return matrix;
    }
    std::array<double, 3> translation{0, 0, 0}, scale{1, 1, 1};
    std::array<double, 4> rotation{0, 0, 0, 1};
    numbers_of(node, "translation", translation);
    numbers_of(node, "scale", scale);
    if (numbers_of(node, "rotation", rotation)) {
        const glm::dquat q(rotation[3], rotation[0], rotation[1], rotation[2]);
        if (const double length = glm::length(q); length > 0.0) matrix = glm::mat4_cast(q / length);
    }
    for (int i = 0; i < 3; ++i) {
        matrix[i] *= scale[static_cast<std::size_t>(i)];
        matrix[3][i] = translation[static_cast<std::size_t>(i)];
    }
    return matrix;
}

class GltfReader
{
public:
    GltfReader(const std::filesystem::path& path, const GltfDocument& document, ReadingNotes& notes)
        : path_(path), document_(document), builder_(path, notes)
    {
    }

    TriangleSoup read()
    {
        for (const GltfJson& material : list(document_.json, "materials"))
            builder_.soup.materials.push_back(to_material(material));
        plan_streams();
        const GltfJson& nodes = list(document_.json, "nodes");
        if (nodes.empty()) {
            // A library of meshes: each once.
            for (std::size_t i = 0; i < list(document_.json, "meshes").size(); ++i) add_mesh(i, glm::dmat4(1.0));
        } else {
            for (const std::size_t root : roots()) add_node(nodes[root], glm::dmat4(1.0));
        }
        return builder_.finish();
    }

private:
    static const GltfJson& list(const GltfJson& object, const char* name)
    {
        static const GltfJson kEmpty = GltfJson::array();
        const auto found = object.find(name);
        return found != object.end() ? *found : kEmpty;
    }

    /// Of the scene that the file opens with; of the first where it names none, or all where it has no scenes.
    std::vector<std::size_t> roots() const
    {
        const GltfJson& scenes = list(document_.json, "scenes");
        const GltfJson& nodes = list(document_.json, "nodes");
        std::vector<std::size_t> roots;
        if (!scenes.empty()) {
            for (const GltfJson& root : list(scenes[document_.json.value("scene", std::size_t{0})], "nodes"))
                roots.push_back(root.get<std::size_t>());
            return roots;
        }
        std::vector<bool> is_child(nodes.size(), false);
        for (const GltfJson& node : nodes)
            for (const GltfJson& child : list(node, "children")) is_child[child.get<std::size_t>()] = true;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!is_child[i]) roots.push_back(i);
        return roots;
    }

    Material to_material(const GltfJson& source) const
    {
        Material material;
        if (const auto name = source.find("name"); name != source.end() && name->is_string())
            material.name = name->get<std::string>();
        const auto look = source.find("pbrMetallicRoughness");
        if (look == source.end() || !look->is_object()) return material;
        const GltfJson& colour = list(*look, "baseColorFactor");
        const auto is_fraction = [](const GltfJson& n) {
            return n.is_number() && n.get<double>() >= 0.0 && n.get<double>() <= 1.0;
        };
        if (colour.is_array() && colour.size() == 4 && std::all_of(colour.begin(), colour.end(), is_fraction))
            for (int i = 0; i < 4; ++i) material.colour[i] = colour[static_cast<std::size_t>(i)].get<float>();
        material.texture = texture_of(*look);
        return material;
    }

    /// Path of the colour texture; empty for none and for an image inside the file, which has no name that would mean
    /// anything outside. Materials are decoration: what makes no sense is left out.
    std::string texture_of(const GltfJson& look) const
    {
        const auto refer = [&](const GltfJson& object, const char* name, const char* target) -> const GltfJson* {
            const auto index = object.find(name);
            if (index == object.end() || !index->is_number_unsigned()) return nullptr;
            const GltfJson& targets = list(document_.json, target);
            const auto i = index->get<std::uint64_t>();
            return i < targets.size() ? &targets[static_cast<std::size_t>(i)] : nullptr;
        };
        const auto use = look.find("baseColorTexture");
        if (use == look.end() || !use->is_object()) return {};
        const GltfJson* texture = refer(*use, "index", "textures");
        const GltfJson* image = texture != nullptr ? refer(*texture, "source", "images") : nullptr;
        if (image == nullptr || !image->contains("uri") || !(*image)["uri"].is_string()) return {};
        const std::string uri = (*image)["uri"].get<std::string>();
        return uri.starts_with("data:") ? std::string() : uri;
    }

    static bool is_surface(const GltfJson& primitive) { return mode_of(primitive) >= kGltfTriangles; }
    static std::uint64_t mode_of(const GltfJson& primitive) { return primitive.value("mode", kGltfTriangles); }

    const GltfAccessor* attribute(const GltfJson& primitive, const std::string& name) const
    {
        const GltfJson& attributes = primitive["attributes"];
        const auto found = attributes.find(name);
        return found != attributes.end() ? &document_.accessors[found->get<std::size_t>()] : nullptr;
    }

    /// One stream for everything that some mesh has; others get white and 0.
    void plan_streams()
    {
        for (const GltfJson& mesh : list(document_.json, "meshes"))
            for (const GltfJson& primitive : mesh["primitives"]) {
                if (!is_surface(primitive)) continue;
                has_colour_ = has_colour_ || attribute(primitive, "COLOR_0") != nullptr;
                for (std::uint32_t k = 1; k < kMostUvSets; ++k)
                    if (attribute(primitive, "TEXCOORD_" + std::to_string(k)) != nullptr)
                        uv_sets_ = std::max(uv_sets_, k + 1);
            }
        if (has_colour_) builder_.soup.streams.push_back({"color", 4, {}});
        for (std::uint32_t k = 1; k < uv_sets_; ++k) builder_.soup.streams.push_back({"uv" + std::to_string(k), 2, {}});
    }

    /// Recursion is as deep as check_gltf() lets nodes be nested.
    void add_node(const GltfJson& node, const glm::dmat4& parent)
    {
        const glm::dmat4 transform = parent * transform_of(node);
        if (const auto mesh = node.find("mesh"); mesh != node.end()) add_mesh(mesh->get<std::size_t>(), transform);
        for (const GltfJson& child : list(node, "children"))
            add_node(list(document_.json, "nodes")[child.get<std::size_t>()], transform);
    }

    void add_mesh(std::size_t number, const glm::dmat4& transform)
    {
        for (const GltfJson& primitive : list(document_.json, "meshes")[number]["primitives"])
            if (is_surface(primitive)) add_primitive(primitive, "mesh " + std::to_string(number), transform);
    }

    void add_primitive(const GltfJson& primitive, const std::string& where, const glm::dmat4& transform)
    {
        find_corners(primitive, where);
        const std::vector<std::uint32_t> index = add_vertices(primitive, transform);
        builder_.use_material(material_of(primitive));
        // A transform that mirrors turns triangles inside out.
        const bool mirrored = glm::determinant(glm::dmat3(transform)) < 0.0;
        const std::uint64_t mode = mode_of(primitive), n = corners_.size();
        const auto add = [&](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
            if (mirrored) std::swap(a, c);
            const std::array<std::uint32_t, 3> triangle{index[corners_[a]], index[corners_[b]], index[corners_[c]]};
            builder_.add_face(triangle);
        };
        if (mode == kGltfTriangles)
            for (std::uint64_t i = 0; i < n; i += 3) add(i, i + 1, i + 2);
        else
            for (std::uint64_t i = 0; i + 2 < n; ++i)
                mode == kGltfFan ? add(0, i + 1, i + 2) : add(i, i + 1 + i % 2, i + 2 - i % 2);
    }

    /// Fills `corners_`: the vertex of the primitive at each corner, in range.
    void find_corners(const GltfJson& primitive, const std::string& where)
    {
        const std::uint64_t vertices = attribute(primitive, "POSITION")->count;
        corners_.clear();
        const auto found = primitive.find("indices");
        const GltfAccessor* indices =
            found != primitive.end() ? &document_.accessors[found->get<std::size_t>()] : nullptr;
        const std::uint64_t count = indices != nullptr ? indices->count : vertices;
        if (count > std::numeric_limits<std::uint32_t>::max())
            fail(path_, where + " has more than 2^32 corners; divide it into several");
        corners_.reserve(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            corners_.push_back(indices != nullptr ? index_at(*indices, i) : static_cast<std::uint32_t>(i));
            if (corners_.back() >= vertices)
                fail(path_, "corner " + std::to_string(i) + " of " + where + " names vertex " +
                                std::to_string(corners_.back()) + ", but there are only " + std::to_string(vertices) +
                                "; export it again");
        }
    }

    /// Primitives without a material share one without a name.
    std::uint32_t material_of(const GltfJson& primitive)
    {
        const auto found = primitive.find("material");
        if (found != primitive.end()) return found->get<std::uint32_t>();
        const std::size_t given = list(document_.json, "materials").size();
        if (builder_.soup.materials.size() == given) builder_.soup.materials.emplace_back();
        return static_cast<std::uint32_t>(given);
    }

    /// Adds the vertices that corners use (primitives may share one long list) and returns their indices.
    std::vector<std::uint32_t> add_vertices(const GltfJson& primitive, const glm::dmat4& transform)
    {
        constexpr std::uint32_t kUnused = 0xFFFFFFFFu;
        const GltfAccessor& positions = *attribute(primitive, "POSITION");
        const GltfAccessor* normals = attribute(primitive, "NORMAL");
        const GltfAccessor* uv = attribute(primitive, "TEXCOORD_0");
        std::vector<std::uint32_t> index(positions.count, kUnused);
        for (const std::uint32_t corner : corners_) index[corner] = 0;
        const bool moved = transform != glm::dmat4(1.0);
        // Normals follow the inverse transpose; up to its length, which is restored later, that is the cofactor matrix.
        const glm::dmat3 linear(transform);
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
        for (std::uint64_t i = 0; i < positions.count; ++i) {
            if (index[i] == kUnused) continue;
            Vertex v{{}, kNoNormal, {}};
            const glm::vec3 p(value_at(positions, i));
            v.position = moved ? glm::vec3(glm::dvec3(transform * glm::dvec4(glm::dvec3(p), 1.0))) : p;
            if (normals != nullptr) {
                const glm::vec3 n(value_at(*normals, i));
                v.normal = moved ? unit(side * (cofactors * glm::dvec3(n))) : n;
            }
            // The origin of glTF's uv is the upper left corner.
            if (uv != nullptr) v.uv = lower_left(value_at(*uv, i));
            index[i] = builder_.add_vertex(v);
            add_streams(primitive, i);
        }
        return index;
    }

    static glm::vec2 lower_left(const glm::vec4& uv) { return {uv.x, 1.0f - uv.y}; }

    static glm::vec3 unit(const glm::dvec3& n)
    {
        const double length = std::hypot(n.x, n.y, n.z);
        return length > 0.0 ? glm::vec3(n / length) : kNoNormal;
    }

    void add_streams(const GltfJson& primitive, std::uint64_t i)
    {
        auto stream = builder_.soup.streams.begin();
        if (has_colour_) {
            const GltfAccessor* colours = attribute(primitive, "COLOR_0");
            const glm::vec4 colour = colours != nullptr ? value_at(*colours, i) : glm::vec4(1.0f);
            for (int k = 0; k < 4; ++k) stream->values.push_back(colour[k]);
            ++stream;
        }
        for (std::uint32_t k = 1; k < uv_sets_; ++k, ++stream) {
            const GltfAccessor* uv = attribute(primitive, "TEXCOORD_" + std::to_string(k));
            const glm::vec2 place = uv != nullptr ? lower_left(value_at(*uv, i)) : glm::vec2(0.0f);
            stream->values.push_back(place.x);
            stream->values.push_back(place.y);
        }
    }

    const std::filesystem::path& path_;
    const GltfDocument& document_;
    SoupBuilder builder_;
    bool has_colour_ = false;
    std::uint32_t uv_sets_ = 1;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

TriangleSoup read_gltf(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    const GltfDocument document = check_gltf(path, bytes);
    return GltfReader(path, document, notes).read();
}

}  // namespace kerf::io
