#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "common/mesh/indexed_mesh.h"
#include "common/repair/adjacency.h"

namespace kerf::core {

struct Repaired;
enum class FactsWanted : std::uint8_t;
struct Proof;
struct TriangleSoup;

/// A mesh that is known to keep all promises of IndexedMesh, so that back ends need not check it. Only `repair()` and
/// `prove()` make one; a default or moved-from one has no triangles.
///
/// Reads like a `const IndexedMesh`. A mesh that is copied or taken out (`*std::move(proven)`) may be changed, and is
/// no longer proven.
class ProvenMesh
{
public:
    ProvenMesh() = default;
    ProvenMesh(const ProvenMesh&) = default;
    ProvenMesh(ProvenMesh&& other) noexcept
        : mesh_(std::move(other.mesh_)),
          adjacency_(std::move(other.adjacency_)),
          bounds_(std::exchange(other.bounds_, Box())),
          shortest_edge_(std::exchange(other.shortest_edge_, kNoEdge)),
          is_closed_(std::exchange(other.is_closed_, true))
    {
        other.forget_counts();
    }
    ProvenMesh& operator=(ProvenMesh other) noexcept
    {
        mesh_ = std::move(other.mesh_);
        adjacency_ = std::move(other.adjacency_);
        bounds_ = other.bounds_;
        shortest_edge_ = other.shortest_edge_;
        is_closed_ = other.is_closed_;
        return *this;
    }

    const IndexedMesh& operator*() const& { return mesh_; }
    const IndexedMesh* operator->() const { return &mesh_; }
    operator const IndexedMesh&() const& { return mesh_; }

    /// Found by the proof; empty once the mesh has been taken out.
    const Adjacency& adjacency() const { return adjacency_; }

    /// Smallest box around the vertices; empty without triangles, and once the mesh has been taken out.
    const Box& bounds() const { return bounds_; }

    /// Length of the shortest edge, in mesh units; infinite without triangles, and once the mesh has been taken out.
    double shortest_edge() const { return shortest_edge_; }

    /// Whether every edge has two triangles, so that the surface bounds solids. True without triangles.
    bool is_closed() const { return is_closed_; }

    /// Takes the mesh out.
    IndexedMesh operator*() &&
    {
        adjacency_ = {};
        bounds_ = {};
        shortest_edge_ = kNoEdge;
        is_closed_ = true;
        IndexedMesh mesh = std::move(mesh_);
        forget_counts();
        return mesh;
    }
    /// The reference would dangle at the end of the line: write `*repair(soup).mesh`, which is a mesh of its own.
    operator const IndexedMesh&() const&& = delete;

    /// Materials may be changed: no promise is about how they look.
    std::span<Material> materials() { return mesh_.materials; }
    /// Appends a material and returns its index.
    std::uint32_t add_material(Material material)
    {
        mesh_.materials.push_back(std::move(material));
        return static_cast<std::uint32_t>(mesh_.materials.size() - 1);
    }

private:
    friend Repaired repair(TriangleSoup soup, FactsWanted facts_wanted);
    friend Proof prove(IndexedMesh mesh);
    ProvenMesh(IndexedMesh&& mesh, Adjacency&& adjacency, const Box& bounds, double shortest_edge, bool is_closed)
        : mesh_(std::move(mesh)),
          adjacency_(std::move(adjacency)),
          bounds_(bounds),
          shortest_edge_(shortest_edge),
          is_closed_(is_closed)
    {
    }

    static constexpr double kNoEdge = std::numeric_limits<double>::infinity();

    /// After a move, which has emptied all arrays.
    void forget_counts() noexcept { mesh_.point_count = adjacency_.shell_count = 0; }

    IndexedMesh mesh_;
    Adjacency adjacency_;
    Box bounds_;
    double shortest_edge_ = kNoEdge;
    bool is_closed_ = true;
};

/// A mesh ready for a back end, or the reason why it can't be cut.
struct Proof
{
    ProvenMesh mesh;    ///< empty if there is an error
    std::string error;  ///< empty, or one sentence that names the first promise of IndexedMesh that is broken
};

/// Proves that a mesh keeps what IndexedMesh promises: that it passes check(), that each directed edge occurs once, and
/// that the triangles around each point form one vertex fan. Pairs the half-edges. For meshes made by hand; the meshes
/// of `repair()` are proven. O(n) time and memory. Throws std::bad_alloc.
Proof prove(IndexedMesh mesh);

}  // namespace kerf::core
