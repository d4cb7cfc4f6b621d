#include "common/io/gltf_document.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/read_formats.h"

namespace kerf::io {

namespace {

using Json = nlohmann::json;

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kContainerHeader = 12, kChunkHeader = 8;
constexpr std::string_view kJsonChunk = "JSON";
constexpr std::string_view kBinaryChunk{"BIN\0", 4};

/// Depth of the node tree: Assimp walks it by recursion.
constexpr std::uint64_t kDeepestNode = 500;
/// Assimp copies a mesh's vertices for each of its primitives, and we for each node: this many times the file's own
/// size are allowed, so that a small file cannot ask for all memory.
constexpr std::uint64_t kMostCopies = 64, kAlwaysAllowed = 1 << 20;

enum ComponentType : std::uint64_t
{
    kInt8 = 5120,
    kUint8 = 5121,
    kInt16 = 5122,
    kUint16 = 5123,
    kUint32 = 5125,
    kFloat32 = 5126
};

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
    Checker(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

    CheckedGltf run()
    {
        parts_ = split();
        document_ = Json::parse(parts_.json, nullptr, false);
        if (document_.is_discarded()) refuse("its JSON is malformed or cut off");
        if (!document_.is_object()) refuse("its JSON is not an object");
        check_version();
        leave_out_what_does_not_matter();
        check_buffers();
        check_views();
        check_accessors();
        check_meshes();
        check_nodes();
        return {assembled(), triangles_};
    }

private:
    [[noreturn]] void refuse(const std::string& reason) const { fail(path_, reason); }

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
    const Json& list(const char* name) const { return list(document_, name, "the document"); }

    const Json& list(const Json& object, const char* name, const std::string& where) const
    {
        static const Json kEmpty = Json::array();
        const auto found = object.find(name);
        if (found == object.end()) return kEmpty;
        if (!found->is_array()) refuse("'" + std::string(name) + "' of " + where + " is not an array");
        return *found;
    }

    std::optional<std::uint64_t> number_if(const Json& object, const char* name, const std::string& where) const
    {
        if (!object.is_object()) refuse(where + " is not an object");
        const auto found = object.find(name);
        if (found == object.end()) return std::nullopt;
        constexpr std::uint64_t kTooLarge = std::uint64_t{1} << 48;
        if (!found->is_number_unsigned() || found->get<std::uint64_t>() >= kTooLarge)
            refuse("'" + std::string(name) + "' of " + where + " is not a number that makes sense");
        return found->get<std::uint64_t>();
    }

    std::uint64_t number(const Json& object, const char* name, const std::string& where) const
    {
        const auto value = number_if(object, name, where);
        if (!value) refuse("'" + std::string(name) + "' of " + where + " is missing");
        return *value;
    }

    void check_version() const
    {
        const auto asset = document_.find("asset");
        if (asset == document_.end() || !asset->is_object()) refuse("it does not say which version of glTF it is");
        const auto version = asset->find("version");
        if (version == asset->end() || !version->is_string() || !version->get<std::string>().starts_with("2"))
            refuse("it is not version 2 of glTF");
        constexpr std::array<std::string_view, 2> kHarmless{"KHR_materials_unlit", "KHR_texture_transform"};
        for (const Json& extension : list("extensionsRequired")) {
            const std::string name = extension.is_string() ? extension.get<std::string>() : "?";
            if (std::find(kHarmless.begin(), kHarmless.end(), name) == kHarmless.end() &&
                !name.starts_with("KHR_materials_"))
                refuse("it needs the extension " + name + ", which is not supported");
        }
    }

    void leave_out_what_does_not_matter()
    {
        for (const char* name :
             {"animations", "skins", "cameras", "extensions", "extensionsUsed", "extensionsRequired", "extras"})
            document_.erase(name);
        for (const char* name : {"nodes", "meshes", "materials", "scenes", "accessors", "bufferViews", "buffers",
                                 "images", "textures", "samplers"}) {
            const auto found = document_.find(name);
            if (found == document_.end()) continue;
            if (!found->is_array()) refuse("'" + std::string(name) + "' is not an array");
            for (std::size_t i = 0; i < found->size(); ++i) {
                Json& object = (*found)[i];
                if (!object.is_object()) refuse(std::string(name) + " " + std::to_string(i) + " is not an object");
                for (const char* part : {"skin", "camera", "weights", "extensions", "extras"}) object.erase(part);
            }
        }
    }

    void check_buffers()
    {
        std::size_t i = 0;
        for (const Json& buffer : list("buffers")) {
            const std::string where = "buffer " + std::to_string(i);
            const std::uint64_t size = number(buffer, "byteLength", where);
            const std::uint64_t there = buffer_bytes(buffer, i == 0, where);
            if (there < size)
                refuse("it is truncated: " + where + " should have " + std::to_string(size) + " bytes, but has " +
                       std::to_string(there));
            buffer_sizes_.push_back(size);
            ++i;
        }
    }

    /// Bytes that a buffer really has.
    std::uint64_t buffer_bytes(const Json& buffer, bool is_first, const std::string& where)
    {
        const auto uri = buffer.find("uri");
        if (uri == buffer.end()) {
            if (!is_first || !parts_.is_container) refuse(where + " has no data");
            return parts_.binary.size();
        }
        if (!uri->is_string()) refuse("'uri' of " + where + " is not a text");
        const std::string& text = uri->get_ref<const std::string&>();
        if (text.starts_with("data:")) {
            const std::size_t data = text.find(";base64,");
            if (data == std::string::npos) refuse(where + " has data that are not base64");
            std::size_t digits = text.size() - (data + 8);
            while (digits > 0 && text[data + 8 + digits - 1] == '=') --digits;
            return digits * 3 / 4;
        }
        std::error_code error;
        const std::filesystem::path file = path_.parent_path() / text;
        if (!std::filesystem::is_regular_file(file, error)) refuse("its buffer " + text + " is not there");
        const std::uint64_t size = std::filesystem::file_size(file, error);
        if (error) refuse("its buffer " + text + " cannot be read");
        beside_ += size;
        return size;
    }

    void check_views()
    {
        std::size_t i = 0;
        for (const Json& view : list("bufferViews")) {
            const std::string where = "buffer view " + std::to_string(i++);
            const std::uint64_t buffer = number(view, "buffer", where), size = number(view, "byteLength", where);
            const std::uint64_t offset = number_if(view, "byteOffset", where).value_or(0);
            if (buffer >= buffer_sizes_.size()) refuse(where + " names a buffer that does not exist");
            if (offset + size > buffer_sizes_[buffer]) refuse(where + " is not inside its buffer");
            const std::uint64_t stride = number_if(view, "byteStride", where).value_or(0);
            if (stride > 252) refuse(where + " has a stride of more than 252 bytes");
            views_.push_back({size, stride});
        }
    }

    struct View
    {
        std::uint64_t size = 0, stride = 0;
    };

    struct Accessor
    {
        std::uint64_t count = 0, component = 0, width = 0;
        bool normalized = false;
    };

    static std::uint64_t component_size(std::uint64_t type)
    {
        switch (type) {
            case kInt8:
            case kUint8:
                return 1;
            case kInt16:
            case kUint16:
                return 2;
            case kUint32:
            case kFloat32:
                return 4;
            default:
                return 0;
        }
    }

    void check_accessors()
    {
        constexpr std::array<std::pair<std::string_view, std::uint64_t>, 7> kWidths{
            {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
        std::size_t i = 0;
        for (const Json& accessor : list("accessors")) {
            const std::string where = "accessor " + std::to_string(i++);
            Accessor a;
            a.count = number(accessor, "count", where);
            a.component = number(accessor, "componentType", where);
            const auto type = accessor.find("type");
            if (type != accessor.end() && type->is_string())
                for (const auto& [name, width] : kWidths)
                    if (type->get_ref<const std::string&>() == name) a.width = width;
            const std::uint64_t element = component_size(a.component) * a.width;
            if (element == 0) refuse(where + " has a type that glTF does not know");
            if (a.count == 0) refuse(where + " is empty");
            if (accessor.contains("sparse")) refuse(where + " is sparse, which is not supported");
            const std::uint64_t view = number(accessor, "bufferView", where);
            if (view >= views_.size()) refuse(where + " names a buffer view that does not exist");
            const std::uint64_t offset = number_if(accessor, "byteOffset", where).value_or(0);
            const std::uint64_t stride = views_[view].stride != 0 ? views_[view].stride : element;
            if (stride < element) refuse(where + " has elements that are longer than their stride");
            if (a.count > views_[view].size || offset + (a.count - 1) * stride + element > views_[view].size)
                refuse(where + " is not inside its buffer view");
            accessors_.push_back(a);
        }
    }

    const Accessor& accessor(const Json& object, const char* name, const std::string& where) const
    {
        const std::uint64_t index = number(object, name, where);
        if (index >= accessors_.size()) refuse(where + " names an accessor that does not exist");
        return accessors_[index];
    }

    void check_meshes()
    {
        Json& meshes = document_["meshes"];
        if (meshes.is_null()) meshes = Json::array();
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            std::uint64_t work = 0;
            if (!meshes[i].contains("primitives")) refuse("mesh " + std::to_string(i) + " has no primitives");
            Json& primitives = meshes[i]["primitives"];
            if (!primitives.is_array()) refuse("the primitives of mesh " + std::to_string(i) + " are not an array");
            for (Json& primitive : primitives) work += check_primitive(primitive, "mesh " + std::to_string(i));
            work_of_mesh_.push_back(work);
        }
    }

    /// Returns the number of vertices and indices.
    std::uint64_t check_primitive(Json& primitive, const std::string& where)
    {
        if (!primitive.is_object()) refuse("a primitive of " + where + " is not an object");
        for (const char* part : {"targets", "extensions", "extras"}) primitive.erase(part);
        if (!primitive.contains("attributes") || !primitive["attributes"].is_object())
            refuse("a primitive of " + where + " has no attributes");
        Json& attributes = primitive["attributes"];
        const auto is_wanted = [](const std::string& name) {
            return name == "POSITION" || name == "NORMAL" || name.starts_with("TEXCOORD_") ||
                   name.starts_with("COLOR_");
        };
        for (auto it = attributes.begin(); it != attributes.end();)
            it = is_wanted(it.key()) ? std::next(it) : attributes.erase(it);

        const Accessor& position = accessor(attributes, "POSITION", where);
        for (const auto& [name, ignored] : attributes.items()) {
            const Accessor& a = accessor(attributes, name.c_str(), where);
            if (a.count != position.count) refuse(name + " of " + where + " does not have one value for each vertex");
            const bool is_float = a.component == kFloat32;
            const bool is_fraction = a.component == kUint8 || a.component == kUint16;
            bool right = is_float && a.width == 3;
            if (name.starts_with("TEXCOORD_")) right = (is_float || a.component == kUint16) && a.width == 2;
            if (name.starts_with("COLOR_")) right = (is_float || is_fraction) && (a.width == 3 || a.width == 4);
            if (!right) refuse(name + " of " + where + " has a type of number that is not supported");
        }
        std::uint64_t count = position.count;
        if (primitive.contains("indices")) {
            const Accessor& indices = accessor(primitive, "indices", where);
            const bool right =
                indices.component == kUint8 || indices.component == kUint16 || indices.component == kUint32;
            if (!right || indices.width != 1) refuse("the indices of " + where + " are not unsigned integers");
            count = indices.count;
        }
        constexpr std::uint64_t kTriangles = 4, kFan = 6;
        const std::uint64_t mode = number_if(primitive, "mode", where).value_or(kTriangles);
        if (mode > kFan) refuse("a primitive of " + where + " has a mode that glTF does not know");
        if (mode == kTriangles ? count % 3 != 0 : (mode > kTriangles && count < 3))
            refuse("a primitive of " + where + " has " + std::to_string(count) +
                   " corners, which is not whole triangles");
        if (mode >= kTriangles) triangles_ += mode == kTriangles ? count / 3 : count - 2;
        return position.count + count;
    }

    void check_nodes() const
    {
        const Json& nodes = list("nodes");
        std::vector<char> is_child(nodes.size(), 0);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const std::string where = "node " + std::to_string(i);
            for (const Json& child : list(nodes[i], "children", where)) {
                const std::uint64_t index = child.is_number_unsigned() ? child.get<std::uint64_t>() : nodes.size();
                if (index >= nodes.size()) refuse(where + " has a child that does not exist");
                if (is_child[index]++ != 0) refuse("node " + std::to_string(index) + " has two parents");
            }
            for (const auto& [name, size] :
                 {std::pair{"matrix", 16u}, {"translation", 3u}, {"rotation", 4u}, {"scale", 3u}}) {
                const auto found = nodes[i].find(name);
                if (found == nodes[i].end()) continue;
                if (!found->is_array() || found->size() != size ||
                    !std::all_of(found->begin(), found->end(), [](const Json& n) { return n.is_number(); }))
                    refuse("'" + std::string(name) + "' of " + where + " is not " + std::to_string(size) + " numbers");
            }
        }
        // Every node that a root reaches is reached once; what no root reaches is a cycle, and is never visited.
        std::uint64_t work = 0;
        for (const Json& scene : list("scenes"))
            for (const Json& root : list(scene, "nodes", "a scene")) {
                const std::uint64_t index = root.is_number_unsigned() ? root.get<std::uint64_t>() : nodes.size();
                if (index >= nodes.size()) refuse("a scene names a node that does not exist");
                if (is_child[index] != 0)
                    refuse("a scene names node " + std::to_string(index) + ", which is not a root");
            }
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (is_child[i] == 0) work += check_tree(nodes, i);
        const std::uint64_t most = std::max(kAlwaysAllowed, kMostCopies * (bytes_.size() + beside_));
        for (const std::uint64_t mesh : work_of_mesh_) work += mesh;
        if (work > most) refuse("its nodes repeat its meshes so often that they would not fit into memory");
    }

    /// Vertices and indices below a root.
    std::uint64_t check_tree(const Json& nodes, std::size_t root) const
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
            for (const Json& child : list(nodes[index], "children", where))
                stack.emplace_back(child.get<std::size_t>(), depth + 1);
        }
        return work;
    }

    /// What is left, in the form in which it came.
    std::string assembled() const
    {
        std::string json = document_.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (!parts_.is_container) return json;
        json.resize((json.size() + 3) / 4 * 4, ' ');
        std::string binary(parts_.binary);
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        std::string bytes(kMagic);
        store_little(bytes, std::uint32_t{2});
        const std::size_t binary_size = binary.empty() ? 0 : kChunkHeader + binary.size();
        store_little(bytes, static_cast<std::uint32_t>(kContainerHeader + kChunkHeader + json.size() + binary_size));
        store_little(bytes, static_cast<std::uint32_t>(json.size()));
        bytes += kJsonChunk;
        bytes += json;
        if (binary.empty()) return bytes;
        store_little(bytes, static_cast<std::uint32_t>(binary.size()));
        bytes += kBinaryChunk;
        bytes += binary;
        return bytes;
    }

    const std::filesystem::path& path_;
    std::string_view bytes_;
    Parts parts_;
    Json document_;
    std::uint64_t triangles_ = 0;
    std::uint64_t beside_ = 0;  ///< bytes of buffers in files of their own
    std::vector<std::uint64_t> buffer_sizes_;
    std::vector<View> views_;
    std::vector<Accessor> accessors_;
    std::vector<std::uint64_t> work_of_mesh_;
};

}  // namespace

CheckedGltf checked_gltf(const std::filesystem::path& path, std::string_view bytes)
{
    return Checker(path, bytes).run();
}

}  // namespace kerf::io
