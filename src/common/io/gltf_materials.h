#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "common/io/gltf_document.h"
#include "common/mesh/triangle_soup.h"

namespace kerf::core::io {

/// A material and how its colour texture lies on the surface.
struct GltfMaterial
{
    Material material;
    std::uint64_t uv_set = 0;  ///< the texture coordinates that the texture uses

    /// KHR_texture_transform, in glTF's coordinates: the matrix times uv, plus the offset.
    glm::dvec2 row_u{1.0, 0.0}, row_v{0.0, 1.0}, offset{0.0, 0.0};

    bool moves_texture() const;
    glm::dvec2 place(const glm::dvec2& uv) const;
};

/// The materials of a document. They are decoration: invalid members are left out and never refuse a file.
std::vector<GltfMaterial> gltf_materials(const GltfDocument& document);

}  // namespace kerf::core::io
