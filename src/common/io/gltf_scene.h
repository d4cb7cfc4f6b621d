#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "common/io/gltf_accessors.h"
#include "common/io/gltf_document.h"

// What a scene of glTF shows: meshes at their places, instances included.

namespace kerf::core::io {

/// Copies of a mesh in one place (EXT_mesh_gpu_instancing), each with a transform of its own.
struct GltfInstances
{
    std::uint64_t count = 1;
    const GltfAccessor* translation = nullptr;
    const GltfAccessor* rotation = nullptr;
    const GltfAccessor* scale = nullptr;

    glm::dmat4 transform(std::uint64_t i) const;
};

/// A mesh as placed by a node of the scene.
struct GltfPlacement
{
    std::uint64_t mesh = 0;
    glm::dmat4 transform{1.0};
    GltfInstances instances;
};

/// The meshes of the scene that the file opens with (of the first if it names none), in the order of a walk from its
/// nodes. If there is no scene, or one that shows no mesh: those of all nodes; if these show none, each mesh once.
///
/// Each node stands in one place: a node that the scene or its parent names twice is there once, and one that both name
/// is there below its parent. A scene may begin at nodes below others; the transforms of those others are ignored. Only
/// transforms of nodes above meshes are looked at. O(nodes).
/// @throws FileError  a reference out of range, a node with two parents or below itself, an invalid transform
std::vector<GltfPlacement> placements_of(const GltfDocument& document, GltfAccessors& accessors);

}  // namespace kerf::core::io
