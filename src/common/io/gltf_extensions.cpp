#include "common/io/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

constexpr std::array<std::string_view, 3> kRead{"KHR_mesh_quantization", "EXT_mesh_gpu_instancing",
                                                "KHR_texture_transform"};

/// These belong to meshes, primitives, accessors, buffer views or buffers and do not change the triangles. Of Draco and
/// both kinds of meshopt compression the uncompressed copy is read; its reader refuses a file without one.
constexpr std::array<std::string_view, 11> kHarmless{"KHR_draco_mesh_compression",
                                                     "KHR_materials_variants",
                                                     "KHR_xmp",
                                                     "KHR_xmp_json_ld",
                                                     "EXT_mesh_features",
                                                     "EXT_structural_metadata",
                                                     "EXT_mesh_manifold",
                                                     "FB_ngon_encoding",
                                                     "CESIUM_primitive_outline",
                                                     "EXT_meshopt_compression",
                                                     "KHR_meshopt_compression"};

template <class Names>
bool has(const Names& names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

GltfExtensions::GltfExtensions(const GltfDocument& document) : document_(document)
{
    for (const GltfJson& extension : document.list("extensionsRequired")) {
        const std::string name = extension.is_string() ? extension.get<std::string>() : "?";
        required_.insert(name);
        if (!has(kRead, name)) document.notes().add("required extension " + in_quotes(name) + " passed over");
    }
}

void GltfExtensions::check(const GltfJson& object, const std::string& where) const
{
    const GltfJson* extensions = document_.object_if(object, "extensions");
    if (extensions == nullptr) return;
    for (const auto& [name, ignored] : extensions->items())
        if (required_.contains(name) && !has(kRead, name) && !has(kHarmless, name) &&
            document_.member(*extensions, name.c_str()) != nullptr)
            document_.refuse(where + " needs the extension " + in_quotes(name) +
                             ", which may change its triangles and is not supported; export it without");
}

}  // namespace kerf::core::io
