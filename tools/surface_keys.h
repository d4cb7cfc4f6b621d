#pragma once

#include <cstdint>
#include <vector>

#include "tools/flat_mesh.h"

namespace kerf::tools {

/// The surface triangles of a mesh in an order that depends on what they are and not on how they are numbered: meshes
/// with the same set of surface triangles have the same order. Refers to the mesh.
class SurfaceKeys
{
public:
    struct Key
    {
        std::uint64_t hash;      ///< of everything that compare_surfaces() compares
        std::uint32_t triangle;  ///< index into the mesh
        std::uint32_t group;     ///< the triangle's group
        std::uint32_t corner;    ///< where to begin counting its corners
    };

    /// O(n log n).
    explicit SurfaceKeys(const FlatMesh& mesh);

    const FlatMesh& mesh() const { return *mesh_; }
    const std::vector<Key>& sorted() const { return keys_; }

    /// Position of corner `i`, counted in the canonical way.
    const glm::vec3& position(const Key& key, std::uint32_t i) const
    {
        return mesh_->vertices[mesh_->triangles[key.triangle][(key.corner + i) % 3]].position;
    }

private:
    const FlatMesh* mesh_;
    std::vector<Key> keys_;
};

/// What is in one multiset of triangles and not in the other.
struct SurfaceDifference
{
    std::uint64_t only_first = 0, only_second = 0;
    bool other_layout = false;  ///< the meshes differ in their streams or materials: nothing else was compared

    bool none() const { return only_first == 0 && only_second == 0 && !other_layout; }
};

/// Compares surface triangles as multisets: bits of all attributes and streams of their corners in cyclic order,
/// source, material and solid. Hashes only say what to compare; the answer is exact. O(n) after the keys.
SurfaceDifference compare_surfaces(const SurfaceKeys& first, const SurfaceKeys& second);

}  // namespace kerf::tools
