#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "common/cutting/cut.h"
#include "common/mesh/indexed_mesh.h"
#include "common/repair/proven_mesh.h"
#include "halfedge/universe/append_buffer.h"
#include "halfedge/universe/fair_shared_mutex.h"
#include "halfedge/universe/surface_mesh.h"
#include "halfedge/universe/triangle_tree.h"

// The universe: one set of buffers (half-edges, vertices, slots, tree) that all fragments of one prepared mesh share,
// with the lock that puts readers and cuts in order.

namespace kerf::core::halfedge {

/// The material, solid and kind of triangles that are drawn together.
struct DrawGroup
{
    std::uint32_t material = 0;
    std::uint32_t solid = 0;
    TriangleKind kind = TriangleKind::surface;
};

/// The order in which groups are drawn and exported.
inline bool draws_before(const DrawGroup& a, const DrawGroup& b)
{
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.material != b.material ? a.material < b.material : a.solid < b.solid;
}

/// One float stream of the vertices.
struct Stream
{
    std::string name;
    std::uint32_t width = 1;
    AppendBuffer<float> values;
};

/// Everything that descends from one prepared mesh: connectivity, vertices, triangles and tree nodes of all fragments,
/// in the mesh's own coordinates. Arrays only grow; a face id and a slot never move.
///
/// A *face* is a triangle of the half-edge mesh. A *slot* is its place in the index buffer: a cut writes the triangles
/// around the section to new slots at the end, and the old ones are dead.
///
/// Fragments may be used by different threads: a reader of the arrays holds `mutex` shared, a cut holds it alone.
struct Universe
{
    mutable FairSharedMutex mutex;

    SurfaceMesh mesh;
    AppendBuffer<Vertex> vertices;               ///< the vertex buffer
    std::vector<Stream> streams;                 ///< run parallel to `vertices`
    AppendBuffer<Triangle, SlotId> slots;        ///< the index buffer
    AppendBuffer<FaceId, SlotId> face_of_slot;   ///< corner 0 of a slot is the origin of its face's half-edge
    AppendBuffer<Index, FaceId> source_of_face;  ///< input triangle, or kNoSource
    AppendBuffer<Index, FaceId> stamp_of_face;   ///< scratch of cuts: `stamp_base` + number of the crossing triangle
    std::uint64_t stamp_base = 1;
    TriangleTree tree;
    std::vector<DrawGroup> groups;
    std::vector<Material> materials;                   ///< grows by make_room_for_material()
    std::uint32_t cap_material = kDefaultCapMaterial;  ///< the one that was added for caps, if one was
    glm::dvec3 reference{0.0};  ///< mass moments are summed about it: the centre of the prepared mesh
    double noise = 0.0;         ///< plane_noise() of the prepared mesh
    bool has_boundary = false;  ///< some fragment may be open: the prepared mesh was, or a section was not closed

    std::size_t uploaded_vertices = 0, uploaded_slots = 0;  ///< counts that the GPU has

    std::atomic<std::size_t> live_slots = 0;  ///< slots that some fragment draws; fragments end without the lock

    Universe() = default;
    /// The copy has a lock of its own. Call it with `other` locked.
    Universe(const Universe& other);
    Universe& operator=(const Universe&) = delete;

    /// Takes over the materials of a mesh, with room for the one that caps may add.
    void set_materials(const std::vector<Material>& from);

    /// Makes room for one more. Views of relatives show the materials, so those never move: where there is no room, a
    /// larger copy goes on, and the old ones stay as long as the universe.
    void make_room_for_material();

    const Vertex& vertex(VertexId v) const { return vertices[v.number()]; }
    const DrawGroup& group(GroupId id) const { return groups[id.number()]; }

    /// For the tree of an object of so many triangles.
    TreeGeometry geometry(std::uint64_t triangles) const
    {
        return {{vertices.data(), vertices.size()}, {slots.data(), slots.size()}, reference, triangles > kFewForMass};
    }
    TreeGeometry geometry() const { return geometry(slots.size()); }

    /// Bytes held, reserve included.
    std::size_t bytes_reserved() const;

private:
    std::vector<std::vector<Material>> outgrown_materials_;
};

/// A connected part of an object: what a shell of the prepared mesh has become.
struct ShellRoot
{
    NodeId root;
    std::uint32_t solid = 0;
    /// The triangles, caps included, are known to be connected by edges and closed or bounded by boundary of the
    /// prepared mesh only. False: unknown.
    bool connected = true;
};

/// Fills an empty universe with a mesh: triangles in Morton order, half-edges, the tree, and reserved room for the
/// cuts that the options name (crossings_of_one_cut()). Returns the shells of the mesh. O(n log n) with a radix sort's constant. Throws Cancelled.
std::vector<ShellRoot> prepare_universe(const ProvenMesh& proven, Universe& universe,
                                        const PrepareOptions& options = {});

}  // namespace kerf::core::halfedge
