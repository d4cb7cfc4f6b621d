#include "halfedge/handover/border.h"

#include <utility>

namespace kerf::core::halfedge {

Border::Border(const Universe& universe, std::span<const ShellRoot> shells, std::size_t material_count)
    : u_(universe), shells_(shells)
{
    mesh_.materials.assign(u_.materials.begin(), u_.materials.begin() + std::ptrdiff_t(material_count));
}

void Border::divide(std::size_t cells, const Breakable::CellOfBox& cell_of)
{
    // The materials are kept: one may have been added.
    std::vector<Material> materials = std::move(mesh_.materials);
    mesh_ = {};
    std::size_t triangles = 0;
    for (const ShellRoot& shell : shells_) triangles += u_.tree.nodes[shell.root].count;
    collector_.emplace(u_, mesh_, triangles);
    mesh_.materials = std::move(materials);
    whole_.assign(cells, {});
    program_.clear();
    first_op_.assign(1, 0);
    slots_.clear();
    shell_of_.clear();
    for (Index shell = 0; shell < shells_.size(); ++shell) {
        visit(shells_[shell].root, shell, cell_of);
        first_op_.push_back(program_.size());
    }
}

void Border::visit(NodeId node, Index shell, const Breakable::CellOfBox& cell_of)
{
    ++nodes_visited_;
    const Node& n = u_.tree.nodes[node];
    if (const std::uint32_t cell = cell_of(n.box); cell != kNone) return set_aside(node, shell, cell);
    if (n.is_leaf()) return add_leaf(node, shell);
    visit(n.left, shell, cell_of);
    visit(n.right, shell, cell_of);
    program_.push_back({ShareOp::Kind::join, node});
}

void Border::set_aside(NodeId node, Index shell, std::uint32_t cell)
{
    program_.push_back({ShareOp::Kind::whole, node, cell});
    const MassMoments& moments = u_.tree.moments[node];
    Breakable::Whole& whole = whole_[cell];
    if (whole.shells.empty() || whole.shells.back() != shell) whole.shells.push_back(shell);
    whole.triangles += u_.tree.nodes[node].count;
    whole.volume += moments.volume6 / 6.0;
    whole.is_known = whole.is_known && shells_[shell].connected && moments.are_known();
}

void Border::add(SlotId slot, Index shell)
{
    collector_->add(slot);
    slots_.push_back(slot);
    shell_of_.push_back(shells_[shell].connected ? shell : kNone);
}

void Border::add_leaf(NodeId node, Index shell)
{
    const Node& leaf = u_.tree.nodes[node];
    program_.push_back({ShareOp::Kind::leaf, node, static_cast<Index>(slots_.size())});
    collector_->begin_group(leaf.group);
    for (SlotId slot = leaf.first; slot < leaf.first + leaf.count; ++slot) add(slot, shell);
}

void Border::show(std::uint32_t cell)
{
    for (Index shell = 0; shell < shells_.size(); ++shell)
        for (const ShareOp& op : program(shell)) {
            if (op.kind != ShareOp::Kind::whole || op.argument != cell) continue;
            std::vector<TriangleTree::Run> runs;
            u_.tree.append_runs(op.node, runs);
            for (const TriangleTree::Run& run : runs) {
                collector_->begin_group(run.group);
                for (SlotId slot = run.first; slot < run.first + run.count; ++slot) add(slot, shell);
            }
        }
}

std::span<const ShareOp> Border::program(std::size_t shell) const
{
    return std::span(program_).subspan(first_op_[shell], first_op_[shell + 1] - first_op_[shell]);
}

}  // namespace kerf::core::halfedge
