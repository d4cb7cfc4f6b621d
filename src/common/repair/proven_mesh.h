#pragma once

#include <span>
#include <string>
#include <utility>

#include "common/mesh/indexed_mesh.h"
#include "common/repair/adjacency.h"

namespace kerf {

struct Repaired;
struct Proof;
struct TriangleSoup;

/// A mesh that is known to keep all that IndexedMesh promises, so that back ends need not look. `repair()` and
/// `prove()` alone make one; a default or moved-from one has no triangles.
///
/// Reads like a `const IndexedMesh`. Copied or taken out (`*std::move(proven)`) the mesh may be changed, and is proven
/// no more.
class ProvenMesh
{
public:
    ProvenMesh() = default;
    ProvenMesh(const ProvenMesh&) = default;
    ProvenMesh(ProvenMesh&& other) noexcept
        : mesh_(std::exchange(other.mesh_, {})), adjacency_(std::exchange(other.adjacency_, {}))
    {
    }
    ProvenMesh& operator=(ProvenMesh other) noexcept
    {
        mesh_ = std::move(other.mesh_);
        adjacency_ = std::move(other.adjacency_);
        return *this;
    }

    const IndexedMesh& operator*() const& { return mesh_; }
    const IndexedMesh* operator->() const { return &mesh_; }
    operator const IndexedMesh&() const& { return mesh_; }

    /// Found on the way; what was taken out has none.
    const Adjacency& adjacency() const { return adjacency_; }

    /// Takes the mesh out.
    IndexedMesh operator*() &&
    {
        adjacency_ = {};
        return std::exchange(mesh_, {});
    }
    /// Would refer to what is gone at the end of the line: write `*repair(soup).mesh`, which is a mesh of its own.
    operator const IndexedMesh&() const&& = delete;

    /// How materials look, which nothing relies on.
    std::span<Material> materials() { return mesh_.materials; }
    /// Appends a material and returns its index.
    std::uint32_t add_material(Material material)
    {
        mesh_.materials.push_back(std::move(material));
        return static_cast<std::uint32_t>(mesh_.materials.size() - 1);
    }

private:
    friend Repaired repair(TriangleSoup soup);
    friend Proof prove(IndexedMesh mesh);
    ProvenMesh(IndexedMesh&& mesh, Adjacency&& adjacency) : mesh_(std::move(mesh)), adjacency_(std::move(adjacency)) {}

    IndexedMesh mesh_;
    Adjacency adjacency_;
};

/// A mesh ready for a back end, or the reason why it can't be cut.
struct Proof
{
    ProvenMesh mesh;    ///< empty when there is an error
    std::string error;  ///< empty, or one sentence that names the first promise of IndexedMesh that is broken
};

/// Proves that a mesh keeps what IndexedMesh promises: check(), and that each directed edge occurs once and the
/// triangles around each point form one fan, by pairing its half-edges. For meshes that were made by hand; what
/// `repair()` gives is proven. O(n) time and memory. Throws std::bad_alloc.
Proof prove(IndexedMesh mesh);

}  // namespace kerf
