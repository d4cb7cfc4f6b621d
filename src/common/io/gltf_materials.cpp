#include "common/io/gltf_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "common/io/gltf_buffers.h"

namespace kerf::core::io {

namespace {

/// The list of this name; an empty one for anything else.
const GltfJson& any_list(const GltfJson& object, const char* name)
{
    static const GltfJson kEmpty = GltfJson::array();
    const auto found = object.find(name);
    return found != object.end() && found->is_array() ? *found : kEmpty;
}

/// The number of this name; `otherwise` for anything else.
double any_number(const GltfJson& object, const char* name, double otherwise)
{
    const auto found = object.find(name);
    return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

glm::dvec2 any_pair(const GltfJson& object, const char* name, const glm::dvec2& otherwise)
{
    const GltfJson& pair = any_list(object, name);
    return pair.size() == 2 && pair[0].is_number() && pair[1].is_number()
               ? glm::dvec2(pair[0].get<double>(), pair[1].get<double>())
               : otherwise;
}

/// The object that a member of `object` refers to; nullptr if there is none.
const GltfJson* referred(const GltfDocument& document, const GltfJson& object, const char* name, const char* target)
{
    const GltfJson& targets = any_list(document.root(), target);
    const double index = any_number(object, name, -1.0);
    return index >= 0.0 && index < static_cast<double>(targets.size()) ? &targets[static_cast<std::size_t>(index)]
                                                                       : nullptr;
}

/// Path of the picture; empty for none and for one inside the file, whose name means nothing outside.
std::string picture_of(const GltfDocument& document, const GltfJson& use)
{
    const GltfJson* texture = referred(document, use, "index", "textures");
    const GltfJson* image = texture != nullptr ? referred(document, *texture, "source", "images") : nullptr;
    if (image == nullptr || !image->contains("uri") || !(*image)["uri"].is_string()) return {};
    const std::string uri = (*image)["uri"].get<std::string>();
    // Writers that encode nothing are common: what is not encoded is taken as it is.
    return is_data_uri(uri) ? std::string() : percent_decoded(uri).value_or(uri);
}

/// Angles run counter-clockwise as one sees the picture, in which v runs down.
void read_texture_transform(const GltfJson& source, GltfMaterial& material)
{
    const double angle = any_number(source, "rotation", 0.0), c = std::cos(angle), s = std::sin(angle);
    const glm::dvec2 scale = any_pair(source, "scale", {1.0, 1.0});
    material.row_u = {c * scale.x, s * scale.y};
    material.row_v = {-s * scale.x, c * scale.y};
    material.offset = any_pair(source, "offset", {0.0, 0.0});
}

GltfMaterial read_material(const GltfDocument& document, const GltfJson& source)
{
    GltfMaterial made;
    if (const auto name = source.find("name"); name != source.end() && name->is_string())
        made.material.name = name->get<std::string>();
    const GltfJson* look = document.object_if(source, "pbrMetallicRoughness");
    if (look == nullptr) return made;
    const GltfJson& colour = any_list(*look, "baseColorFactor");
    const auto is_fraction = [](const GltfJson& n) {
        return n.is_number() && n.get<double>() >= 0.0 && n.get<double>() <= 1.0;
    };
    if (colour.size() == 4 && std::all_of(colour.begin(), colour.end(), is_fraction))
        for (int i = 0; i < 4; ++i) made.material.colour[i] = colour[static_cast<std::size_t>(i)].get<float>();
    const GltfJson* use = document.object_if(*look, "baseColorTexture");
    if (use == nullptr) return made;
    made.material.texture = picture_of(document, *use);
    made.uv_set = static_cast<std::uint64_t>(std::clamp(any_number(*use, "texCoord", 0.0), 0.0, 100.0));
    if (const GltfJson* transform = document.extension(*use, "KHR_texture_transform")) {
        made.uv_set = static_cast<std::uint64_t>(
            std::clamp(any_number(*transform, "texCoord", static_cast<double>(made.uv_set)), 0.0, 100.0));
        read_texture_transform(*transform, made);
    }
    return made;
}

}  // namespace

bool GltfMaterial::moves_texture() const
{
    return row_u != glm::dvec2(1.0, 0.0) || row_v != glm::dvec2(0.0, 1.0) || offset != glm::dvec2(0.0);
}

glm::dvec2 GltfMaterial::place(const glm::dvec2& uv) const
{
    return glm::dvec2(glm::dot(row_u, uv), glm::dot(row_v, uv)) + offset;
}

std::vector<GltfMaterial> gltf_materials(const GltfDocument& document)
{
    std::vector<GltfMaterial> materials;
    for (const GltfJson& source : any_list(document.root(), "materials"))
        materials.push_back(read_material(document, source));
    return materials;
}

}  // namespace kerf::core::io
