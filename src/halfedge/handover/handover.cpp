#include "halfedge/handover/handover.h"

#include <algorithm>
#include <utility>

#include "halfedge/handover/sewing.h"

namespace kerf::core::halfedge {

namespace {

/// A piece on its way to being a shell.
struct Share
{
    Index cap_count = 0;
    std::uint64_t triangles = 0;  ///< in all
    SlotId cursor;                ///< next slot to write
    GroupId cap_group;
    ShellRoot root;
};

/// What a triangle of the border is to a piece: kept (kNone), or divided, with one of its parts.
struct Part
{
    Index piece = 0;
    Index triangle = 0;
};

/// A part of a tree, of a piece.
struct Result
{
    Index piece = 0;
    NodeId node;
};

class HandoverRun
{
public:
    HandoverRun(Universe& universe, std::span<const ShellRoot> shells, const Border& border,
                std::span<const PieceBorder> pieces, std::uint32_t cap_material)
        : u_(universe),
          shells_(shells),
          border_(border),
          pieces_(pieces),
          sewing_(universe, border, pieces),
          shares_(pieces.size()),
          piece_of_cell_(border.cells(), kNone),
          start_(pieces.size()),
          count_(pieces.size(), 0)
    {
        for (Index p = 0; p < pieces.size(); ++p) piece_of_cell_[pieces[p].cell] = p;
        list_parts();
        plan_slots();
        plan_cap_groups(cap_material);
        make_room();
    }

    std::vector<ShellRoot> run()
    {
        sewing_.run(u_);
        u_.groups.insert(u_.groups.end(), new_groups_.begin(), new_groups_.end());
        u_.slots.extend(new_slots_);
        u_.face_of_slot.extend(new_slots_);
        first_fresh_node_ = NodeId(static_cast<Index>(u_.tree.nodes.size()));
        for (std::size_t shell = 0; shell < shells_.size(); ++shell) {
            run_program(border_.program(shell));
            for (const Result& result : results_) {
                NodeId& root = shares_[result.piece].root.root;
                root = u_.tree.join(root, result.node);
            }
        }
        for (Index p = 0; p < pieces_.size(); ++p) add_caps(p);
        std::vector<ShellRoot> roots;
        for (const Share& share : shares_) roots.push_back(share.root);
        return roots;
    }

private:
    /// The parts of each triangle of the border, by piece.
    void list_parts()
    {
        first_part_.assign(border_.slots().size() + 1, 0);
        const auto for_each = [&](auto visit) {
            for (Index p = 0; p < pieces_.size(); ++p) {
                for (const Index triangle : pieces_[p].kept) visit(triangle, Part{p, kNone});
                for (Index t = 0; t < pieces_[p].surface_count; ++t) visit(pieces_[p].divided[t], Part{p, t});
            }
        };
        for_each([&](Index triangle, const Part&) { ++first_part_[triangle + 1]; });
        for (std::size_t t = 1; t < first_part_.size(); ++t) first_part_[t] += first_part_[t - 1];
        parts_.resize(first_part_.back());
        std::vector<std::size_t> place(first_part_.begin(), first_part_.end() - 1);
        for_each([&](Index triangle, const Part& part) { parts_[place[triangle]++] = part; });
    }

    std::span<const Part> parts_of(Index triangle) const
    {
        return std::span(parts_).subspan(first_part_[triangle], first_part_[triangle + 1] - first_part_[triangle]);
    }

    /// A piece has its slots side by side, the caps behind the surface.
    void plan_slots()
    {
        const SlotId first(static_cast<Index>(u_.slots.size()));
        SlotId slot = first;
        for (Index p = 0; p < pieces_.size(); ++p) {
            Share& share = shares_[p];
            const auto surface = static_cast<Index>(pieces_[p].kept.size() + pieces_[p].surface_count);
            share.cap_count = static_cast<Index>(pieces_[p].mesh.triangles.size()) - pieces_[p].surface_count;
            share.triangles = border_.whole_of(pieces_[p].cell).triangles + surface + share.cap_count;
            share.cursor = slot;
            slot = slot + (surface + share.cap_count);
        }
        new_slots_ = slot - first;
    }

    void plan_cap_groups(std::uint32_t material)
    {
        for (Index p = 0; p < pieces_.size(); ++p) {
            const DrawGroup wanted{material, pieces_[p].solid, TriangleKind::cap};
            shares_[p].root.solid = wanted.solid;
            const auto is_it = [&](const DrawGroup& group) {
                return !draws_before(group, wanted) && !draws_before(wanted, group);
            };
            auto found = static_cast<std::size_t>(std::ranges::find_if(u_.groups, is_it) - u_.groups.begin());
            if (found == u_.groups.size()) {
                const auto added = std::ranges::find_if(new_groups_, is_it);
                found += static_cast<std::size_t>(added - new_groups_.begin());
                if (added == new_groups_.end()) new_groups_.push_back(wanted);
            }
            shares_[p].cap_group = GroupId(static_cast<Index>(found));
        }
    }

    void make_room()
    {
        sewing_.make_room(u_);
        u_.slots.make_room(new_slots_);
        u_.face_of_slot.make_room(new_slots_);
        u_.groups.reserve(u_.groups.size() + new_groups_.size());
        // Each part of a leaf, and what joins it or a subtree that was set aside.
        std::size_t nodes = 0;
        for (std::size_t shell = 0; shell < shells_.size(); ++shell)
            for (const ShareOp& op : border_.program(shell)) {
                nodes += op.kind == ShareOp::Kind::whole ? 1 : 0;
                if (op.kind == ShareOp::Kind::leaf) nodes += nodes_for_leaf(op);
            }
        for (const Share& share : shares_) nodes += TriangleTree::nodes_of_full_leaves(share.cap_count) + 1;
        // Leaves and subtrees of several shells are joined as those of one are, and the caps with them.
        u_.tree.make_room(nodes);
    }

    /// Those of each piece's part of a leaf, and one that joins it.
    std::size_t nodes_for_leaf(const ShareOp& op)
    {
        touched_.clear();
        for (Index i = 0; i < u_.tree.nodes[op.node].count; ++i)
            for (const Part& part : parts_of(op.argument + i))
                if (count_[part.piece]++ == 0) touched_.push_back(part.piece);
        std::size_t nodes = 0;
        for (const Index piece : touched_) {
            const Index count = std::exchange(count_[piece], 0);
            nodes += 1 + (count <= kMaxLeafTriangles ? 1 : TriangleTree::nodes_of_full_leaves(count));
        }
        return nodes;
    }

    void run_program(std::span<const ShareOp> program)
    {
        results_.clear();
        lengths_.clear();
        for (const ShareOp& op : program) switch (op.kind) {
                case ShareOp::Kind::whole: {
                    const Index piece = piece_of_cell_[op.argument];
                    if (piece != kNone) results_.push_back({piece, op.node});
                    lengths_.push_back(piece != kNone ? 1 : 0);
                    break;
                }
                case ShareOp::Kind::leaf:
                    rewrite(op);
                    break;
                case ShareOp::Kind::join:
                    join_results();
                    break;
            }
    }

    void rewrite(const ShareOp& op)
    {
        const Node leaf = u_.tree.nodes[op.node];
        touched_.clear();
        for (Index i = 0; i < leaf.count; ++i)
            for (const Part& part : parts_of(op.argument + i)) {
                SlotId& cursor = shares_[part.piece].cursor;
                if (!start_[part.piece].is_valid()) {
                    start_[part.piece] = cursor;
                    touched_.push_back(part.piece);
                }
                const SlotId old = leaf.first + i;
                const bool is_kept = part.triangle == kNone;
                u_.slots[cursor] = is_kept ? u_.slots[old] : sewing_.triangle(part.piece, part.triangle);
                u_.face_of_slot[cursor] = is_kept ? u_.face_of_slot[old] : sewing_.face(part.piece, part.triangle);
                ++cursor;
            }
        std::ranges::sort(touched_);
        for (const Index piece : touched_) {
            const SlotId first = start_[piece];
            start_[piece] = SlotId();
            results_.push_back({piece, make_part(piece, first, shares_[piece].cursor - first, leaf.group)});
        }
        lengths_.push_back(touched_.size());
    }

    NodeId make_part(Index piece, SlotId first, Index count, GroupId group)
    {
        const TreeGeometry geometry = u_.geometry(shares_[piece].triangles);
        return count <= kMaxLeafTriangles ? u_.tree.make_leaf(geometry, first, count, group)
                                          : u_.tree.make_run(geometry, first, count, group);
    }

    void join_results()
    {
        const std::size_t right = lengths_.back(), left = lengths_[lengths_.size() - 2];
        lengths_.pop_back();
        const std::size_t end = results_.size(), middle = end - right, begin = middle - left;
        // The merged list is built behind the two and moved down.
        std::size_t l = begin, r = middle;
        while (l < middle || r < end) {
            if (r == end || (l < middle && results_[l].piece < results_[r].piece)) {
                results_.push_back(Result(results_[l++]));
            } else if (l == middle || results_[r].piece < results_[l].piece) {
                results_.push_back(Result(results_[r++]));
            } else {
                const Index piece = results_[l].piece;
                results_.push_back({piece, join(results_[l++].node, results_[r++].node)});
            }
        }
        lengths_.back() = results_.size() - end;
        results_.erase(results_.begin() + std::ptrdiff_t(begin), results_.begin() + std::ptrdiff_t(end));
    }

    NodeId join(NodeId left, NodeId right)
    {
        const Node &l = u_.tree.nodes[left], &r = u_.tree.nodes[right];
        if (left >= first_fresh_node_ && right >= first_fresh_node_ && l.is_leaf() && r.is_leaf() &&
            l.group == r.group && l.first + l.count == r.first && l.count + r.count <= kMaxLeafTriangles)
            return u_.tree.merge_leaves(left, right);
        return u_.tree.join(left, right);
    }

    void add_caps(Index p)
    {
        Share& share = shares_[p];
        const SlotId first = share.cursor;
        for (Index c = 0; c < share.cap_count; ++c) {
            const std::size_t t = pieces_[p].surface_count + c;
            u_.slots[share.cursor] = sewing_.triangle(p, t);
            u_.face_of_slot[share.cursor] = sewing_.face(p, t);
            ++share.cursor;
        }
        share.root.root = u_.tree.join(
            share.root.root, u_.tree.make_run(u_.geometry(share.triangles), first, share.cap_count, share.cap_group));
    }

    Universe& u_;
    std::span<const ShellRoot> shells_;
    const Border& border_;
    std::span<const PieceBorder> pieces_;
    Sewing sewing_;
    std::vector<Share> shares_;
    std::vector<Index> piece_of_cell_;
    std::vector<std::size_t> first_part_;  ///< of each triangle of the border, and the end
    std::vector<Part> parts_;
    std::vector<DrawGroup> new_groups_;
    Index new_slots_ = 0;
    NodeId first_fresh_node_;

    // Of the program that runs
    std::vector<Result> results_;       ///< of the subtrees that are not joined yet, each ascending by piece
    std::vector<std::size_t> lengths_;  ///< of their lists
    std::vector<SlotId> start_;         ///< of the leaf that is rewritten, for each piece that has some of it
    std::vector<Index> count_;          ///< the same: of its triangles
    std::vector<Index> touched_;        ///< those pieces
};

}  // namespace

std::vector<ShellRoot> hand_over(Universe& universe, std::span<const ShellRoot> shells, const Border& border,
                                 std::span<const PieceBorder> pieces, std::uint32_t cap_material)
{
    return HandoverRun(universe, shells, border, pieces, cap_material).run();
}

}  // namespace kerf::core::halfedge
