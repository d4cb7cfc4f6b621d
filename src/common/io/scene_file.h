#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "common/mesh/indexed_mesh.h"

namespace kerf::core::io {

/// A mesh in a scene.
struct SceneNode
{
    std::string name;
    const IndexedMesh* mesh = nullptr;
    glm::dvec3 translation{0.0};
    std::string extras;  ///< JSON, what else there is to say of it; empty for nothing
};

/// The bytes of a GLB file with a node for each. Materials that are alike are written once. What a mesh file has no place
/// for is left out, as by write_mesh().
/// @throws FileError  a mesh that check() refuses; extras that are no JSON; more than 4 GB
std::string scene_bytes(std::span<const SceneNode> nodes);

}  // namespace kerf::core::io
