#include "common/io/gltf_document.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "common/io/bytes.h"
#include "common/io/read_formats.h"
#include "common/io/text_scanner.h"

namespace kerf::io {

namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kContainerHeader = 12, kChunkHeader = 8;
constexpr std::string_view kJsonChunk = "JSON";
constexpr std::string_view kBinaryChunk{"BIN\0", 4};

/// Depth of the node tree, which is walked by recursion.
constexpr std::uint64_t kDeepestNode = 500;
/// Every node copies the vertices of its mesh: this many times the file's own size are allowed, so that a small file
/// cannot ask for all memory.
constexpr std::uint64_t kMostCopies = 64, kAlwaysAllowed = 1 << 20;

/// The chunks of a GLB file, or the text of a glTF file.
struct Parts
{
    std::string_view json;
    std::string_view binary;
    bool is_container = false;
};

class Checker
{
public:
    Checker(const std::filesystem::path& path, std::string_view bytes)
        : path_(path), bytes_(bytes), document_{{}, GltfBuffers(path), {}}
    {
    }

    GltfDocument run()
    {
        parts_ = split();
        json_ = parse_json();
        if (!json_.is_object()) refuse("its JSON is not an object");
        check_version();
        check_lists();
        check_buffers();
        check_views();
        check_accessors();
        check_meshes();
        check_nodes();
        return std::move(document_);
    }

private:
    /// With the remedy, unless the reason has one of its own.
    [[noreturn]] void refuse(const std::string& reason) const
    {
        fail(path_, reason.find("; ") != std::string::npos ? reason : reason + "; export it again as glTF 2.0");
    }

    GltfJson parse_json() const
    {
        try {
            return GltfJson::parse(parts_.json);
        } catch (const GltfJson::parse_error& error) {
            if (!parts_.is_container && path_.extension() == ".glb")
                refuse("it does not begin with 'glTF', as binary glTF does, and what it holds is no JSON either");
            refuse("its JSON is malformed or cut off at byte " + std::to_string(error.byte));
        } catch (const GltfJson::exception&) {
            refuse("its JSON holds a number that is too large");
        }
    }

    Parts split() const
    {
        if (!bytes_.starts_with(kMagic)) return {bytes_, {}, false};
        if (bytes_.size() < kContainerHeader + kChunkHeader) refuse("it is truncated");
        const auto number = [&](std::size_t at) { return load<std::uint32_t>(bytes_.data() + at, Endian::little); };
        if (number(4) != 2) refuse("it is GLB version " + std::to_string(number(4)) + ", not 2");
        if (number(8) > bytes_.size())
            refuse("it is truncated: it should have " + std::to_string(number(8)) + " bytes, but has " +
                   std::to_string(bytes_.size()));
        const std::size_t end = number(8);
        Parts parts;
        parts.is_container = true;
        for (std::size_t at = kContainerHeader; at + kChunkHeader <= end;) {
            const std::size_t size = number(at), first = at + kChunkHeader;
            const std::string_view type = bytes_.substr(at + 4, 4);
            if (size > end - first) refuse("a chunk is longer than the file");
            if (at == kContainerHeader && type != kJsonChunk) refuse("its first chunk is not JSON");
            if (type == kJsonChunk && parts.json.empty()) parts.json = bytes_.substr(first, size);
            if (type == kBinaryChunk && parts.binary.empty()) parts.binary = bytes_.substr(first, size);
            at = first + (size + 3) / 4 * 4;
        }
        return parts;
    }

    /// An array of the document; an empty one where there is none.
    const GltfJson& list(const char* name) const { return list(json_, name, "the document"); }

    const GltfJson& list(const GltfJson& object, const char* name, const std::string& where) const
    {
        static const GltfJson kEmpty = GltfJson::array();
        const auto found = object.find(name);
        if (found == object.end()) return kEmpty;
        if (!found->is_array()) refuse("'" + std::string(name) + "' of " + where + " is not an array");
        return *found;
    }

    std::optional<std::uint64_t> number_if(const GltfJson& object, const char* name, const std::string& where) const
    {
        if (!object.is_object()) refuse(where + " is not an object");
        const auto found = object.find(name);
        if (found == object.end()) return std::nullopt;
        constexpr std::uint64_t kTooLarge = std::uint64_t{1} << 48;
        if (!found->is_number_unsigned() || found->get<std::uint64_t>() >= kTooLarge)
            refuse("'" + std::string(name) + "' of " + where + " is not a number that makes sense");
        return found->get<std::uint64_t>();
    }

    std::uint64_t number(const GltfJson& object, const char* name, const std::string& where) const
    {
        const auto value = number_if(object, name, where);
        if (!value) refuse("'" + std::string(name) + "' of " + where + " is missing");
        return *value;
    }

    void check_version() const
    {
        const auto asset = json_.find("asset");
        if (asset == json_.end() || !asset->is_object()) refuse("it does not say which version of glTF it is");
        const auto version = asset->find("version");
        if (version == asset->end() || !version->is_string() || !version->get<std::string>().starts_with("2"))
            refuse("it is not version 2 of glTF");
        constexpr std::array<std::string_view, 2> kHarmless{"KHR_materials_unlit", "KHR_texture_transform"};
        for (const GltfJson& extension : list("extensionsRequired")) {
            const std::string name = extension.is_string() ? extension.get<std::string>() : "?";
            if (std::find(kHarmless.begin(), kHarmless.end(), name) == kHarmless.end() &&
                !name.starts_with("KHR_materials_"))
                refuse("it needs the extension " + in_quotes(name) + ", which is not supported; export it without");
        }
    }

    /// Everything that others refer to is an object in an array.
    void check_lists() const
    {
        for (const char* name :
             {"nodes", "meshes", "materials", "scenes", "accessors", "bufferViews", "buffers", "images", "textures"}) {
            std::size_t i = 0;
            for (const GltfJson& object : list(name)) {
                if (!object.is_object()) refuse(std::string(name) + " " + std::to_string(i) + " is not an object");
                ++i;
            }
        }
    }

    void check_buffers()
    {
        std::size_t i = 0;
        for (const GltfJson& buffer : list("buffers")) {
            const std::string where = "buffer " + std::to_string(i);
            const std::uint64_t size = number(buffer, "byteLength", where);
            const std::string_view bytes = buffer_bytes(buffer, i == 0, where);
            if (bytes.size() < size)
                refuse("it is truncated: " + where + " should have " + std::to_string(size) + " bytes, but has " +
                       std::to_string(bytes.size()));
            of_buffer_.push_back(bytes.substr(0, size));
            ++i;
        }
    }

    /// Bytes that a buffer really has.
    std::string_view buffer_bytes(const GltfJson& buffer, bool is_first, const std::string& where)
    {
        const auto uri = buffer.find("uri");
        if (uri == buffer.end()) {
            if (!is_first || !parts_.is_container) refuse(where + " has no data");
            return parts_.binary;
        }
        if (!uri->is_string()) refuse("'uri' of " + where + " is not a text");
        return document_.buffers.bytes_of(uri->get_ref<const std::string&>(), where);
    }

    void check_views()
    {
        std::size_t i = 0;
        for (const GltfJson& view : list("bufferViews")) {
            const std::string where = "buffer view " + std::to_string(i++);
            const std::uint64_t buffer = number(view, "buffer", where), size = number(view, "byteLength", where);
            const std::uint64_t offset = number_if(view, "byteOffset", where).value_or(0);
            if (buffer >= of_buffer_.size()) refuse(where + " names a buffer that does not exist");
            if (offset + size > of_buffer_[buffer].size()) refuse(where + " is not inside its buffer");
            const std::uint64_t stride = number_if(view, "byteStride", where).value_or(0);
            if (stride > 252) refuse(where + " has a stride of more than 252 bytes");
            views_.push_back({of_buffer_[buffer].substr(offset, size), stride});
        }
    }

    struct View
    {
        std::string_view bytes;
        std::uint64_t stride = 0;
    };

    static std::uint64_t component_size(std::uint64_t type)
    {
        switch (static_cast<GltfComponent>(type)) {
            case GltfComponent::int8:
            case GltfComponent::uint8:
                return 1;
            case GltfComponent::int16:
            case GltfComponent::uint16:
                return 2;
            case GltfComponent::uint32:
            case GltfComponent::float32:
                return 4;
        }
        return 0;
    }

    void check_accessors()
    {
        constexpr std::array<std::pair<std::string_view, std::uint64_t>, 7> kWidths{
            {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
        std::size_t i = 0;
        for (const GltfJson& accessor : list("accessors")) {
            const std::string where = "accessor " + std::to_string(i++);
            GltfAccessor a;
            a.count = number(accessor, "count", where);
            const std::uint64_t component = number(accessor, "componentType", where);
            const auto type = accessor.find("type");
            if (type != accessor.end() && type->is_string())
                for (const auto& [name, width] : kWidths)
                    if (type->get_ref<const std::string&>() == name) a.width = width;
            const std::uint64_t element = component_size(component) * a.width;
            if (element == 0) refuse(where + " has a type that glTF does not know");
            if (a.count == 0) refuse(where + " is empty");
            if (accessor.contains("sparse"))
                refuse(where + " is sparse, which is not supported; export it without sparse accessors");
            const std::uint64_t view = number(accessor, "bufferView", where);
            if (view >= views_.size()) refuse(where + " names a buffer view that does not exist");
            const std::uint64_t offset = number_if(accessor, "byteOffset", where).value_or(0);
            const std::string_view bytes = views_[view].bytes;
            a.component = static_cast<GltfComponent>(component);
            a.stride = views_[view].stride != 0 ? views_[view].stride : element;
            if (a.stride < element) refuse(where + " has elements that are longer than their stride");
            if (a.count > bytes.size() || offset + (a.count - 1) * a.stride + element > bytes.size())
                refuse(where + " is not inside its buffer view");
            a.first = bytes.data() + offset;
            document_.accessors.push_back(a);
        }
    }

    const GltfAccessor& accessor(const GltfJson& object, const char* name, const std::string& where) const
    {
        const std::uint64_t index = number(object, name, where);
        if (index >= document_.accessors.size())
            refuse(where + " names accessor " + std::to_string(index) + ", but there are only " +
                   std::to_string(document_.accessors.size()));
        return document_.accessors[index];
    }

    void check_meshes()
    {
        std::size_t i = 0;
        for (const GltfJson& mesh : list("meshes")) {
            const std::string where = "mesh " + std::to_string(i++);
            if (!mesh.contains("primitives")) refuse(where + " has no primitives");
            std::uint64_t work = 0;
            for (const GltfJson& primitive : list(mesh, "primitives", where)) work += check_primitive(primitive, where);
            work_of_mesh_.push_back(work);
        }
    }

    /// Returns the number of vertices and indices.
    std::uint64_t check_primitive(const GltfJson& primitive, const std::string& where)
    {
        if (!primitive.is_object()) refuse("a primitive of " + where + " is not an object");
        if (!primitive.contains("attributes") || !primitive["attributes"].is_object())
            refuse("a primitive of " + where + " has no attributes");
        const GltfJson& attributes = primitive["attributes"];
        const auto is_wanted = [](const std::string& name) {
            return name == "POSITION" || name == "NORMAL" || name.starts_with("TEXCOORD_") ||
                   name.starts_with("COLOR_");
        };
        const GltfAccessor& position = accessor(attributes, "POSITION", where);
        for (const auto& [name, ignored] : attributes.items()) {
            if (!is_wanted(name)) continue;
            const GltfAccessor& a = accessor(attributes, name.c_str(), where);
            if (a.count != position.count)
                refuse(in_quotes(name) + " of " + where + " does not have one value for each vertex");
            const bool is_float = a.component == GltfComponent::float32;
            const bool is_fraction = a.component == GltfComponent::uint8 || a.component == GltfComponent::uint16;
            bool right = is_float && a.width == 3;
            if (name.starts_with("TEXCOORD_")) right = (is_float || is_fraction) && a.width == 2;
            if (name.starts_with("COLOR_")) right = (is_float || is_fraction) && (a.width == 3 || a.width == 4);
            if (!right) refuse(in_quotes(name) + " of " + where + " has a type of number that is not supported");
        }
        std::uint64_t count = position.count;
        if (primitive.contains("indices")) {
            const GltfAccessor& indices = accessor(primitive, "indices", where);
            const bool right = indices.component == GltfComponent::uint8 ||
                               indices.component == GltfComponent::uint16 || indices.component == GltfComponent::uint32;
            if (!right || indices.width != 1) refuse("the indices of " + where + " are not unsigned integers");
            count = indices.count;
        }
        const std::uint64_t mode = number_if(primitive, "mode", where).value_or(kGltfTriangles);
        if (mode > kGltfFan) refuse("a primitive of " + where + " has a mode that glTF does not know");
        if (mode == kGltfTriangles ? count % 3 != 0 : (mode > kGltfTriangles && count < 3))
            refuse("a primitive of " + where + " has " + std::to_string(count) +
                   " corners, which is not whole triangles");
        if (const auto material = number_if(primitive, "material", where);
            material && *material >= list("materials").size())
            refuse(where + " names a material that does not exist");
        return position.count + count;
    }

    void check_nodes() const
    {
        const GltfJson& nodes = list("nodes");
        std::vector<char> is_child(nodes.size(), 0);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const std::string where = "node " + std::to_string(i);
            for (const GltfJson& child : list(nodes[i], "children", where)) {
                const std::uint64_t index = child.is_number_unsigned() ? child.get<std::uint64_t>() : nodes.size();
                if (index >= nodes.size()) refuse(where + " has a child that does not exist");
                if (is_child[index]++ != 0) refuse("node " + std::to_string(index) + " has two parents");
            }
            for (const auto& [name, size] :
                 {std::pair{"matrix", 16u}, {"translation", 3u}, {"rotation", 4u}, {"scale", 3u}}) {
                const auto found = nodes[i].find(name);
                if (found == nodes[i].end()) continue;
                if (!found->is_array() || found->size() != size ||
                    !std::all_of(found->begin(), found->end(), [](const GltfJson& n) { return n.is_number(); }))
                    refuse("'" + std::string(name) + "' of " + where + " is not " + std::to_string(size) + " numbers");
            }
        }
        // Every node that a root reaches is reached once; what no root reaches is a cycle, and is never visited.
        std::uint64_t work = 0;
        for (const GltfJson& scene : list("scenes")) {
            std::vector<char> is_named(nodes.size(), 0);
            for (const GltfJson& root : list(scene, "nodes", "a scene")) {
                const std::uint64_t index = root.is_number_unsigned() ? root.get<std::uint64_t>() : nodes.size();
                if (index >= nodes.size()) refuse("a scene names a node that does not exist");
                if (is_child[index] != 0 || is_named[index]++ != 0)
                    refuse("a scene names node " + std::to_string(index) + ", which is not a root or is there already");
            }
        }
        if (const auto scene = number_if(json_, "scene", "the document"); scene && *scene >= list("scenes").size())
            refuse("'scene' of the document names a scene that does not exist");
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (is_child[i] == 0) work += check_tree(nodes, i);
        if (nodes.empty())
            for (const std::uint64_t mesh : work_of_mesh_) work += mesh;
        const std::uint64_t most =
            std::max(kAlwaysAllowed, kMostCopies * (bytes_.size() + document_.buffers.bytes_beside()));
        if (work > most)
            refuse("its nodes repeat its meshes so often that they would not fit into memory; export fewer copies");
    }

    /// Vertices and indices below a root.
    std::uint64_t check_tree(const GltfJson& nodes, std::size_t root) const
    {
        std::uint64_t work = 0;
        std::vector<std::pair<std::size_t, std::uint64_t>> stack{{root, 0}};
        while (!stack.empty()) {
            const auto [index, depth] = stack.back();
            stack.pop_back();
            const std::string where = "node " + std::to_string(index);
            if (depth > kDeepestNode) refuse("its nodes are nested too deeply");
            if (const auto mesh = number_if(nodes[index], "mesh", where)) {
                if (*mesh >= work_of_mesh_.size()) refuse(where + " names a mesh that does not exist");
                work += work_of_mesh_[*mesh];
            }
            for (const GltfJson& child : list(nodes[index], "children", where))
                stack.emplace_back(child.get<std::size_t>(), depth + 1);
        }
        return work;
    }

    const std::filesystem::path& path_;
    std::string_view bytes_;
    Parts parts_;
    GltfDocument document_;
    GltfJson& json_ = document_.json;
    std::vector<std::string_view> of_buffer_;
    std::vector<View> views_;
    std::vector<std::uint64_t> work_of_mesh_;
};

}  // namespace

GltfDocument check_gltf(const std::filesystem::path& path, std::string_view bytes)
{
    return Checker(path, bytes).run();
}

}  // namespace kerf::io
