#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/cutting/breakable.h"
#include "halfedge/universe/mesh_collector.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// A step of the program that makes trees of cells, in post-order.
struct ShareOp
{
    enum class Kind : std::uint8_t
    {
        whole,  ///< subtree `node` goes to cell `argument`
        leaf,   ///< the triangles of leaf `node` are those of the border from `argument` on
        join,   ///< the results of the last two are joined
    };
    Kind kind;
    NodeId node;
    Index argument = 0;
};

/// What of some shells lies in one cell as a whole, and the rest as a mesh.
class Border
{
public:
    /// All arguments stay as they are meanwhile.
    Border(const Universe& universe, std::span<const ShellRoot> shells, std::size_t material_count);

    /// As Breakable's.
    void divide(std::size_t cells, const Breakable::CellOfBox& cell_of);
    void show(std::uint32_t cell);
    const Breakable::Whole& whole_of(std::uint32_t cell) const { return whole_[cell]; }

    IndexedMesh& mesh() { return mesh_; }
    const IndexedMesh& mesh() const { return mesh_; }
    std::span<const Index> shells() const { return shell_of_; }

    /// What the mesh is made of.
    std::span<const SlotId> slots() const { return slots_; }
    std::span<const Index> old_vertices() const { return collector_->old_vertices(); }
    std::span<const PointId> old_points() const { return collector_->old_points(); }

    std::size_t cells() const { return whole_.size(); }
    /// The program of a shell.
    std::span<const ShareOp> program(std::size_t shell) const;
    std::uint64_t nodes_visited() const { return nodes_visited_; }

private:
    void visit(NodeId node, Index shell, const Breakable::CellOfBox& cell_of);
    void set_aside(NodeId node, Index shell, std::uint32_t cell);
    void add_leaf(NodeId node, Index shell);
    void add(SlotId slot, Index shell);

    const Universe& u_;
    std::span<const ShellRoot> shells_;
    IndexedMesh mesh_;
    std::optional<MeshCollector> collector_;
    std::vector<Breakable::Whole> whole_;  ///< of each cell
    std::vector<ShareOp> program_;
    std::vector<std::size_t> first_op_;  ///< of each shell, and the end
    std::vector<SlotId> slots_;          ///< of each triangle
    std::vector<Index> shell_of_;
    std::uint64_t nodes_visited_ = 0;
};

}  // namespace kerf::core::halfedge
