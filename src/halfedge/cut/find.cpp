#include "halfedge/cut/find.h"

#include <algorithm>

#include "halfedge/cut/crossing_numbers.h"
#include "halfedge/cut/edges_in_plane.h"
#include "halfedge/cut/leaf_distances.h"
#include "halfedge/cut/leaf_prefetch.h"
#include "halfedge/cut/visit_tree.h"

namespace kerf::core::halfedge {

namespace {

/// FIND for one shell: appends its program, crossing triangles and edges in the plane.
template <class Numbers>
class ShellFinder
{
public:
    /// @param shell  its number among the cut shells
    ShellFinder(const Universe& universe, const Plane& plane, Index shell, FindLists& lists, Numbers& numbers,
                Found& found)
        : u_(universe),
          plane_(plane),
          shell_(shell),
          lists_(lists),
          numbers_(numbers),
          found_(found),
          vertices_ahead_(universe)
    {
    }

    /// Returns which sides keep triangles; crossing triangles count for both.
    BySide<bool> run(NodeId root)
    {
        const std::size_t first_op = found_.ops.size();
        const TreeVisit visit = visit_tree(u_, plane_, shell_, root, lists_.visits, found_.ops);
        present_ = visit.present;
        found_.nodes_visited += visit.nodes;
        open_leaves(first_op);
        return present_;
    }

private:
    void open_leaves(std::size_t first_op)
    {
        std::vector<Index>& leaves = lists_.leaves;
        leaves.resize(found_.ops.size() - first_op);
        std::size_t count = 0;
        for (std::size_t i = first_op; i < found_.ops.size(); ++i) {
            leaves[count] = static_cast<Index>(i);
            count += found_.ops[i].kind == TreeOp::Kind::leaf ? 1 : 0;
        }
        constexpr std::size_t kAhead = 2;
        const std::size_t asked_for = u_.geometry().is_far_away() ? count : 0;
        for (std::size_t i = 0; i < count; ++i) {
            vertices_ahead_.aim_at_none();
            if (i + kAhead < asked_for) vertices_ahead_.aim_at(u_.tree.nodes[found_.ops[leaves[i + kAhead]].node]);
            TreeOp& op = found_.ops[leaves[i]];
            op = open_leaf(op.node);
        }
    }

    TargetId target(Side side) const { return first_target(shell_, side); }

    TreeOp whole(NodeId n, Side side)
    {
        present_[side] = true;
        return TreeOp::hand_over(n, target(side));
    }

    TreeOp open_leaf(NodeId n)
    {
        const Node& node = u_.tree.nodes[n];
        distances_.find(plane_, {u_.vertices.data(), u_.vertices.size()}, {&u_.slots[node.first], node.count});
        const std::size_t first_entry = found_.entries.size();
        found_.entries.resize(first_entry + node.count);
        LeafEntry* const entries = &found_.entries[first_entry];
        BySide<std::uint32_t> kept{};
        std::uint32_t crossing = 0;
        for (std::uint32_t i = 0; i < node.count; ++i) {
            vertices_ahead_.step(i);
            const SlotId slot = node.first + i;
            // What classify() says, without branches: which side a triangle is on can't be predicted here.
            const bool above = distances_.is_above(i), below = distances_.is_below(i);
            if (above & below) {
                entries[i] = LeafEntry::to_crossing(static_cast<Index>(found_.crossings.size()));
                add_crossing(slot, node.group, u_.slots[slot], distances_.of(i));
                ++crossing;
                continue;
            }
            const bool on = distances_.is_on(i);
            const Side side = on ? kept_side(u_, plane_, slot, distances_.of(i)) : static_cast<Side>(above);
            ++kept[side];
            entries[i] = LeafEntry::to_target(target(side));
            if (on) add_in_plane_edges(slot, side, distances_.of(i), node.group);
        }
        if (crossing == 0 && (kept[Side::negative] == 0 || kept[Side::positive] == 0)) {
            found_.entries.resize(first_entry);
            found_.triangles_read += node.count;
            return whole(n, kept[Side::negative] == 0 ? Side::positive : Side::negative);
        }
        for (const Side side : kSides) present_[side] |= crossing > 0 || kept[side] > 0;
        LeafCounts counts;
        counts.crossing = static_cast<std::uint8_t>(crossing);
        for (const Side side : kSides) counts.kept[side] = static_cast<std::uint8_t>(kept[side]);
        counts.sides_are_targets = true;
        return {TreeOp::Kind::leaf, n, static_cast<Index>(first_entry), counts};
    }

    void add_crossing(SlotId slot, GroupId group, const Triangle& t, const std::array<double, 3>& d)
    {
        Crossing& c = found_.crossings.add();
        c.slot = slot;
        c.face = u_.face_of_slot[slot];
        c.group = group;
        c.shell = shell_;
        c.target = {target(Side::negative), target(Side::positive)};
        c.bounds_nothing = {};
        c.corner = {VertexId(t[0]), VertexId(t[1]), VertexId(t[2])};
        c.distance = d;
        numbers_.add(c.face);
    }

    /// Edges in the plane at a face, each once: by the face on the negative side where the two are kept on different
    /// sides, by the one of the smaller half-edge otherwise.
    void add_in_plane_edges(SlotId slot, Side side, const std::array<double, 3>& d, GroupId group)
    {
        for_each_edge_in_plane(u_, plane_, slot, side, d, [&](const EdgeInPlane& e) {
            const HalfedgeId h = e.halfedge;
            const FaceId face = u_.face_of_slot[slot];
            if (e.is_flush && (!e.across.is_valid() || h < opposite(h)))
                found_.flush.push_back({h, face, side, target(side)});
            if (e.is_flush || side == Side::positive) return;
            const Triangle& t = u_.slots[slot];
            found_.in_plane.push_back({h,
                                       opposite(h),
                                       face,
                                       e.across,
                                       group,
                                       shell_,
                                       VertexId(t[(e.corner + 1) % 3]),
                                       VertexId(t[e.corner]),
                                       {target(Side::negative), target(Side::positive)}});
        });
    }

    const Universe& u_;
    const Plane& plane_;
    const Index shell_;
    FindLists& lists_;
    Numbers& numbers_;
    Found& found_;
    LeafDistances distances_;
    VertexPrefetch vertices_ahead_;
    BySide<bool> present_{};
};

}  // namespace

Finder::Finder()
{
    reserve(0);
}

void Finder::reserve(std::size_t crossings_expected)
{
    // On the asteroid 1.5 visits for each crossing triangle.
    const std::size_t visits = kFewVisits + 2 * crossings_expected;
    if (lists_.visits.size() < visits) lists_.visits.resize(visits);
    reserve_touched(lists_.leaves, visits);
}

template <class Numbers>
void Finder::run(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane, Numbers& numbers,
                 Found& found)
{
    for (Index i = 0; i < shells.size(); ++i) {
        CutShell cut_shell;
        cut_shell.shell = i;
        cut_shell.solid = shells[i].solid;
        cut_shell.connected = shells[i].connected;
        cut_shell.first_op = found.ops.size();
        cut_shell.first_flush = found.flush.size();
        cut_shell.first_in_plane = found.in_plane.size();
        cut_shell.first_crossing = found.crossings.size();
        const BySide<bool> present =
            ShellFinder(universe, plane, static_cast<Index>(found.shells.size()), lists_, numbers, found)
                .run(shells[i].root);
        if (present[Side::negative] && present[Side::positive]) {
            cut_shell.op_count = found.ops.size() - cut_shell.first_op;
            cut_shell.crossing_count = found.crossings.size() - cut_shell.first_crossing;
            cut_shell.flush_count = found.flush.size() - cut_shell.first_flush;
            cut_shell.in_plane_count = found.in_plane.size() - cut_shell.first_in_plane;
            found.shells.push_back(cut_shell);
        } else {
            found.ops.resize(cut_shell.first_op);
            found.flush.resize(cut_shell.first_flush);
            found.whole[present[Side::positive] ? Side::positive : Side::negative].push_back(shells[i]);
        }
    }
}

template void Finder::run(const Universe&, const std::vector<ShellRoot>&, const Plane&, FaceStamps&, Found&);
template void Finder::run(const Universe&, const std::vector<ShellRoot>&, const Plane&, FaceTable&, Found&);

std::optional<Side> missed_side(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane,
                                std::vector<NodeId>& waiting, std::uint64_t& nodes_visited)
{
    const auto reaches = [&](int sign) {
        return std::ranges::any_of(shells, [&](const ShellRoot& shell) {
            return reaches_beyond(u.tree, u.geometry(), shell.root, plane, u.noise, sign, waiting, nodes_visited);
        });
    };
    if (!reaches(1)) return Side::negative;
    if (!reaches(-1)) return Side::positive;
    return std::nullopt;
}

void Found::reserve(std::size_t crossings_expected)
{
    // Leaves that the plane meets hold about sixteen triangles for each one that crosses.
    reserve_touched(ops, 3 * crossings_expected);
    reserve_touched(entries, 20 * crossings_expected);
    crossings.reserve(crossings_expected);
}

void Found::clear()
{
    for (auto& shells_of_side : whole) shells_of_side.clear();
    shells.clear();
    ops.clear();
    entries.clear();
    crossings.clear();
    in_plane.clear();
    flush.clear();
    nodes_visited = 0;
    triangles_read = 0;
}

bool Found::keeps_triangles(Side side) const
{
    if (!whole[side].empty()) return true;
    const auto goes_to_side = [&](TargetId target) { return side_of_target(target) == side; };
    const auto splits_to_side = [&](const Crossing& c) {
        return std::ranges::any_of(c.split.sub_triangles(), [&](const SubTriangle& t) { return t.side == side; });
    };
    // The first crossing triangle answers, but for spikes.
    return std::any_of(crossings.begin(), crossings.end(), splits_to_side) ||
           std::any_of(ops.begin(), ops.end(),
                       [&](const TreeOp& op) { return op.kind == TreeOp::Kind::whole && goes_to_side(op.target()); }) ||
           std::any_of(entries.begin(), entries.end(),
                       [&](LeafEntry entry) { return !entry.is_crossing() && goes_to_side(entry.target()); });
}

}  // namespace kerf::core::halfedge
