#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/mesh_file.h"
#include "common/io/read_formats.h"
#include "common/io/scene_file.h"
#include "common/io/write_formats.h"

namespace kerf::core::io {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr unsigned kFloat = 5126, kUnsignedInt = 5125;
constexpr unsigned kArrayBuffer = 34962, kElementArrayBuffer = 34963;

/// A path as a relative reference: blanks and characters with a meaning in references are escaped.
std::string uri_of(std::string_view path)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string uri;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_plain = (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
                              (byte >= 'a' && byte <= 'z') ||
                              std::string_view("-._~/").find(c) != std::string_view::npos;
        if (is_plain) {
            uri += c;
        } else {
            uri += '%';
            uri += kDigits[byte >> 4];
            uri += kDigits[byte & 15];
        }
    }
    return uri;
}

class GlbWriter
{
public:
    /// A node for the surface and one for the caps.
    void add(const IndexedMesh& mesh)
    {
        begin(mesh);
        for (const TriangleKind kind : {TriangleKind::surface, TriangleKind::cap}) {
            OrderedJson primitives = primitives_of(kind);
            if (primitives.empty()) continue;
            const char* name = kind == TriangleKind::surface ? "surface" : "cap";
            add_node({{"name", name}, {"mesh", meshes_.size()}});
            meshes_.push_back({{"name", name}, {"primitives", std::move(primitives)}});
        }
    }

    /// One node for all of a mesh.
    void add(const SceneNode& node)
    {
        begin(*node.mesh);
        OrderedJson primitives = primitives_of(TriangleKind::surface);
        for (OrderedJson& primitive : primitives_of(TriangleKind::cap)) primitives.push_back(std::move(primitive));
        OrderedJson described{{"name", node.name}, {"mesh", meshes_.size()}};
        if (node.translation != glm::dvec3(0.0))
            described["translation"] = {node.translation.x, node.translation.y, node.translation.z};
        if (!node.extras.empty()) described["extras"] = OrderedJson::parse(node.extras);
        add_node(std::move(described));
        meshes_.push_back({{"name", node.name}, {"primitives", std::move(primitives)}});
    }

    void write(ByteSink& file) const { write_container(file); }

private:
    /// Materials in the file that are alike.
    struct Alike
    {
        std::vector<std::size_t> numbers;
        std::size_t used = 0;  ///< of them, by this mesh
        std::size_t mesh = 0;
    };

    void begin(const IndexedMesh& mesh)
    {
        mesh_ = &mesh;
        ++meshes_begun_;
        material_numbers_.clear();
        for (const Material& material : mesh.materials) material_numbers_.push_back(number_of(material));
        local_.assign(mesh.vertices.size(), kUnused);
    }

    void add_node(OrderedJson node)
    {
        roots_.push_back(nodes_.size());
        nodes_.push_back(std::move(node));
    }

    /// Its number in the file. Equal materials of several meshes are one; those of one mesh are not.
    std::size_t number_of(const Material& material)
    {
        Alike& alike = known_materials_[{material.name,
                                         material.texture,
                                         {material.colour.r, material.colour.g, material.colour.b, material.colour.a}}];
        if (alike.mesh != meshes_begun_) alike = {std::move(alike.numbers), 0, meshes_begun_};
        if (alike.used == alike.numbers.size()) {
            alike.numbers.push_back(materials_.size());
            add_material(material);
        }
        return alike.numbers[alike.used++];
    }

    void add_material(const Material& source)
    {
        const glm::vec4 c = glm::vec4(source.colour);
        const auto channel = [](float value) { return std::clamp(value, 0.0f, 1.0f); };
        OrderedJson surface{{"baseColorFactor", {channel(c.r), channel(c.g), channel(c.b), channel(c.a)}},
                            {"metallicFactor", 0.0}};
        if (!source.texture.empty()) {
            surface["baseColorTexture"] = {{"index", textures_.size()}};
            textures_.push_back({{"source", images_.size()}});
            images_.push_back({{"uri", uri_of(source.texture)}});
        }
        OrderedJson material;
        if (!source.name.empty()) material["name"] = source.name;
        material["pbrMetallicRoughness"] = std::move(surface);
        if (channel(c.a) < 1.0f) material["alphaMode"] = "BLEND";
        materials_.push_back(std::move(material));
    }

    /// One primitive for each material, with its own vertices in order of use. The cost depends on the groups of this
    /// kind, not on all vertices for each material.
    OrderedJson primitives_of(TriangleKind kind)
    {
        std::vector<std::vector<const TriangleGroup*>> groups(mesh_->materials.size());
        for (const TriangleGroup& group : mesh_->groups)
            if (group.kind == kind) groups[group.material].push_back(&group);
        OrderedJson primitives = OrderedJson::array();
        for (std::uint32_t material = 0; material < groups.size(); ++material) {
            for (const TriangleGroup* group : groups[material]) collect(*group);
            if (!indices_.empty()) primitives.push_back(primitive(material));
            for (const std::uint32_t v : used_) local_[v] = kUnused;
            used_.clear();
            indices_.clear();
        }
        return primitives;
    }

    void collect(const TriangleGroup& group)
    {
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t)
            for (const std::uint32_t v : mesh_->triangles[t]) {
                if (local_[v] == kUnused) {
                    local_[v] = static_cast<std::uint32_t>(used_.size());
                    used_.push_back(v);
                }
                indices_.push_back(local_[v]);
            }
    }

    OrderedJson primitive(std::uint32_t material)
    {
        OrderedJson attributes;
        attributes["POSITION"] = add_positions();
        attributes["NORMAL"] = add_floats(3, [&](std::uint32_t v, int i) { return mesh_->vertices[v].normal[i]; });
        // The origin of glTF's images is the upper left corner.
        attributes["TEXCOORD_0"] = add_floats(2, [&](std::uint32_t v, int i) {
            const glm::vec2& uv = mesh_->vertices[v].uv;
            return i == 0 ? uv.x : 1.0f - uv.y;
        });
        for (const VertexStream& stream : mesh_->streams)
            if (stream.name == "color" && (stream.width == 3 || stream.width == 4))
                attributes["COLOR_0"] = add_floats(static_cast<int>(stream.width), [&](std::uint32_t v, int i) {
                    return stream.values[v * stream.width + static_cast<std::uint32_t>(i)];
                });
        OrderedJson result{{"attributes", std::move(attributes)}};
        const std::size_t first = binary_.size();
        for (const std::uint32_t index : indices_) store_little(binary_, index);
        result["indices"] = add_accessor(first, kElementArrayBuffer, kUnsignedInt, indices_.size(), "SCALAR");
        result["material"] = material_numbers_[material];
        return result;
    }

    std::size_t add_positions()
    {
        const std::size_t accessor =
            add_floats(3, [&](std::uint32_t v, int i) { return mesh_->vertices[v].position[i]; });
        Box box;
        for (const std::uint32_t v : used_) box.add(mesh_->vertices[v].position);
        // As doubles the floats' digits are exact.
        accessors_[accessor]["min"] = {double(box.lo.x), double(box.lo.y), double(box.lo.z)};
        accessors_[accessor]["max"] = {double(box.hi.x), double(box.hi.y), double(box.hi.z)};
        return accessor;
    }

    template <class Value>
    std::size_t add_floats(int width, const Value& value)
    {
        constexpr std::array<const char*, 5> kTypes{"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        const std::size_t first = binary_.size();
        for (const std::uint32_t v : used_)
            for (int i = 0; i < width; ++i) store_little(binary_, value(v, i));
        return add_accessor(first, kArrayBuffer, kFloat, used_.size(), kTypes[static_cast<std::size_t>(width)]);
    }

    /// Describes the bytes from `first` on. All numbers are four bytes long, so everything stays aligned.
    std::size_t add_accessor(std::size_t first, unsigned target, unsigned component, std::size_t count,
                             const char* type)
    {
        views_.push_back(
            {{"buffer", 0}, {"byteOffset", first}, {"byteLength", binary_.size() - first}, {"target", target}});
        accessors_.push_back(
            {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
        return accessors_.size() - 1;
    }

    OrderedJson document() const
    {
        OrderedJson document;
        document["asset"] = {{"version", "2.0"}, {"generator", "Kerf"}};
        document["scene"] = 0;
        document["scenes"] = OrderedJson::array({{{"nodes", roots_}}});
        // The format forbids lists that are empty.
        const auto add = [&](const char* name, const OrderedJson& list) {
            if (!list.empty()) document[name] = list;
        };
        add("nodes", nodes_);
        add("meshes", meshes_);
        add("materials", materials_);
        add("textures", textures_);
        add("images", images_);
        add("accessors", accessors_);
        add("bufferViews", views_);
        document["buffers"] = OrderedJson::array({{{"byteLength", binary_.size()}}});
        return document;
    }

    void write_container(ByteSink& file) const
    {
        std::string json = document().dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
        json.resize((json.size() + 3) / 4 * 4, ' ');
        constexpr std::size_t kHeaders = 12 + 8 + 8;
        if (kHeaders + json.size() + binary_.size() > std::numeric_limits<std::uint32_t>::max())
            fail(file.path(), "the mesh is too large for a GLB file, which ends at 4 GB; write ply instead");
        std::string header = "glTF";
        store_little(header, std::uint32_t{2});
        store_little(header, static_cast<std::uint32_t>(kHeaders + json.size() + binary_.size()));
        store_little(header, static_cast<std::uint32_t>(json.size()));
        file.write(header + "JSON" + json);
        std::string chunk;
        store_little(chunk, static_cast<std::uint32_t>(binary_.size()));
        file.write(chunk + std::string("BIN\0", 4));
        file.write(binary_);
    }

    static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

    const IndexedMesh* mesh_ = nullptr;          ///< that is added
    std::vector<std::size_t> material_numbers_;  ///< of its materials
    std::size_t meshes_begun_ = 0;
    std::map<std::tuple<std::string, std::string, std::array<float, 4>>, Alike> known_materials_;
    OrderedJson roots_ = OrderedJson::array(), nodes_ = OrderedJson::array(), meshes_ = OrderedJson::array(),
                materials_ = OrderedJson::array(), textures_ = OrderedJson::array(), images_ = OrderedJson::array(),
                accessors_ = OrderedJson::array(), views_ = OrderedJson::array();
    std::string binary_;
    std::vector<std::uint32_t> used_;     ///< vertices of the current primitive
    std::vector<std::uint32_t> indices_;  ///< of the current primitive
    std::vector<std::uint32_t> local_;    ///< vertex -> index in used_; kUnused between primitives
};

}  // namespace

void write_glb(ByteSink& file, const IndexedMesh& mesh)
{
    GlbWriter writer;
    writer.add(mesh);
    writer.write(file);
}

std::string scene_bytes(std::span<const SceneNode> nodes)
{
    MemorySink sink("scene.glb");
    try {
        GlbWriter writer;
        for (const SceneNode& node : nodes) {
            if (const std::string fault = check(*node.mesh); !fault.empty())
                fail(sink.path(), "\"" + node.name + "\" cannot be written: " + fault);
            if (!node.extras.empty() && !OrderedJson::accept(node.extras))
                fail(sink.path(), "the extras of \"" + node.name + "\" are no JSON");
            writer.add(node);
        }
        writer.write(sink);
        return sink.take();
    } catch (const std::bad_alloc&) {
        fail_without_memory(sink.path(), "write it; free some");
    }
}

}  // namespace kerf::core::io
