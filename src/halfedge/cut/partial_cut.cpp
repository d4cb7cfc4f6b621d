#include "halfedge/cut/partial_cut.h"

#include <algorithm>
#include <compare>
#include <map>
#include <optional>

#include "common/cutting/joined_pieces.h"
#include "common/geometry/disjoint_sets.h"
#include "common/sections/chosen_paths.h"
#include "halfedge/cut/outline.h"

namespace kerf::core::halfedge {

namespace {

using Place = JoinedPieces::Place;

/// What of one cut shell, or of one solid, comes to one place. A type of this file: a map by a std::tuple with a Side in
/// it would be shown by every library that has Kerf inside, because enumerations don't hide a template's names.
struct PartOfPlace
{
    std::uint32_t of = 0;  ///< the shell, or the solid
    Side side = Side::negative;
    Index fragment = 0;

    friend auto operator<=>(const PartOfPlace&, const PartOfPlace&) = default;
};

class PartialCut
{
public:
    PartialCut(const Universe& universe, const std::vector<ShellRoot>& shells, const std::vector<bool>& is_chosen,
               bool split_components, Found& found, Pieces& pieces)
        : u_(universe),
          shells_(shells),
          is_chosen_(is_chosen),
          split_components_(split_components),
          found_(found),
          pieces_(pieces),
          joined_(pieces.fragment_count),
          surface_(static_cast<std::uint32_t>(pieces.targets.size()))
    {
    }

    bool run()
    {
        join();
        if (!joined_.find()) return false;
        for (const Side side : kSides)
            planned_.fragment_count[side] = split_components_ ? joined_.count(side) : std::min(joined_.count(side), 1u);
        place_whole_shells();
        make_targets();
        make_piece_shells();
        number_crossings();
        for (Index s = 0; s < cut_shells_.size(); ++s) rewrite(s);
        found_.shells = std::move(cut_shells_);
        found_.ops = std::move(ops_);
        found_.in_plane = std::move(in_plane_);
        found_.flush = std::move(flush_);
        found_.whole = std::move(whole_);
        found_.crossings.shorten_to(crossing_count_);
        pieces_ = std::move(planned_);
        return true;
    }

private:
    // ----- what stays together -----

    void join()
    {
        for (Index i = 0; i < found_.crossings.size(); ++i) {
            const OutlineEdgeId edge = found_.edge_of_crossing(i);
            // One without is on the one side or the other as a whole, and only touches the plane.
            if (found_.has_section_edge(edge)) decide(edge, is_chosen_[edge.number()]);
        }
        for (Index i = 0; i < found_.in_plane.size(); ++i) {
            const OutlineEdgeId edge = found_.edge_in_plane(i);
            decide(edge, is_chosen_[edge.number()]);
        }
    }

    void decide(OutlineEdgeId edge, bool is_cut)
    {
        if (bounds_nothing(edge)) return;
        const BySide<TargetId> target{found_.target_of(edge, Side::negative), found_.target_of(edge, Side::positive)};
        const BySide<std::uint32_t> piece{piece_of(target[Side::negative]), piece_of(target[Side::positive])};
        if (is_cut) return joined_.part(piece);
        joined_.join(piece);
        surface_.unite(target[Side::negative].number(), target[Side::positive].number());
    }

    /// On one side all that was at the edge has vanished.
    bool bounds_nothing(OutlineEdgeId edge) const
    {
        return std::ranges::any_of(kSides, [&](Side side) {
            return found_.bounds_nothing(edge, side) || pieces_.target(found_.target_of(edge, side)).is_empty;
        });
    }

    Index piece_of(TargetId target) const { return pieces_.shells[pieces_.target(target).piece_shell].fragment; }

    Place place_of(TargetId target) const { return joined_.place_of(pieces_.target(target).side, piece_of(target)); }

    // ----- where it goes -----

    Index fragment_of(const Place& place) const { return split_components_ ? place.number : 0; }

    void place_whole(const Place& place, const ShellRoot& shell)
    {
        whole_[place.side].push_back(shell);
        planned_.whole_fragment[place.side].push_back(fragment_of(place));
    }

    /// Those that the plane does not meet, and those of which everything comes to one place.
    void place_whole_shells()
    {
        for (const Side side : kSides)
            for (std::size_t i = 0; i < found_.whole[side].size(); ++i)
                place_whole(joined_.place_of(side, pieces_.whole_fragment[side][i]), found_.whole[side][i]);

        std::vector<std::vector<Place>> places(found_.shells.size());
        for (Index t = 0; t < pieces_.targets.size(); ++t)
            if (!pieces_.targets[t].is_empty) places[pieces_.targets[t].shell].push_back(place_of(TargetId(t)));
        for (Index s = 0; s < found_.shells.size(); ++s) {
            const Place first = places[s].front();
            if (std::ranges::all_of(places[s], [&](const Place& place) {
                    return place.side == first.side && fragment_of(place) == fragment_of(first);
                })) {
                place_whole(first, shells_[found_.shells[s].shell]);
                new_shell_.push_back(kNone);
            } else {
                new_shell_.push_back(static_cast<Index>(cut_shells_.size()));
                cut_shells_.push_back(found_.shells[s]);
            }
        }
    }

    /// A target for each place that something of a cut shell comes to. The first one on each side is first_target().
    void make_targets()
    {
        for (Index s = 0; s < cut_shells_.size(); ++s)
            for (const Side side : kSides) add_target(s, side).is_empty = true;
        std::map<PartOfPlace, TargetId> at;
        for (Index t = 0; t < pieces_.targets.size(); ++t) {
            const Target& old = pieces_.targets[t];
            const Index shell = new_shell_[old.shell];
            new_target_.push_back(shell == kNone ? TargetId() : first_target(shell, old.side));
            if (shell == kNone || old.is_empty) continue;
            const Place place = place_of(TargetId(t));
            const auto [entry, is_new] = at.try_emplace(PartOfPlace{shell, place.side, fragment_of(place)});
            if (is_new) {
                entry->second = first_target(shell, place.side);
                if (!planned_.target(entry->second).is_empty) {
                    entry->second = TargetId(static_cast<Index>(planned_.targets.size()));
                    add_target(shell, place.side);
                }
                planned_.target(entry->second).is_empty = false;
                fragment_of_target_[entry->second.number()] = fragment_of(place);
                set_of_target_[entry->second.number()] = surface_.find(t);
            }
            new_target_.back() = entry->second;
            if (set_of_target_[entry->second.number()] != surface_.find(t))
                is_connected_[entry->second.number()] = false;
        }
    }

    Target& add_target(Index shell, Side side)
    {
        Target target;
        target.side = side;
        target.shell = shell;
        planned_.targets.push_back(target);
        fragment_of_target_.push_back(0);
        set_of_target_.push_back(kNone);
        is_connected_.push_back(true);
        return planned_.targets.back();
    }

    /// What of one solid comes to one place is a shell of a fragment.
    void make_piece_shells()
    {
        std::map<PartOfPlace, Index> at;
        std::vector<bool> has_one;
        for (Index t = 0; t < planned_.targets.size(); ++t) {
            Target& target = planned_.targets[t];
            const std::uint32_t solid = cut_shells_[target.shell].solid;
            const auto [entry, is_new] = at.try_emplace(PartOfPlace{solid, target.side, fragment_of_target_[t]},
                                                        static_cast<Index>(planned_.shells.size()));
            if (is_new) {
                PieceShell made;
                made.side = target.side;
                made.solid = solid;
                made.shell = target.shell;
                made.fragment = fragment_of_target_[t];
                planned_.shells.push_back(made);
            }
            target.piece_shell = entry->second;
            if (target.is_empty) continue;
            // Whether caps connect several is not looked into.
            has_one.resize(planned_.shells.size());
            planned_.shells[entry->second].connected = !has_one[entry->second] && is_connected_[t];
            has_one[entry->second] = true;
        }
    }

    // ----- what is found -----

    bool is_parted(OutlineEdgeId edge) const
    {
        return !bounds_nothing(edge) &&
               place_of(found_.target_of(edge, Side::negative)) != place_of(found_.target_of(edge, Side::positive));
    }

    /// Where a face comes to that lies on both sides of an outline edge, or beside it, and is not parted there.
    TargetId common_target(OutlineEdgeId edge) const
    {
        const TargetId target = found_.target_of(edge, Side::negative);
        const bool is_nothing = found_.bounds_nothing(edge, Side::negative) || pieces_.target(target).is_empty;
        return new_target_[(is_nothing ? found_.target_of(edge, Side::positive) : target).number()];
    }

    BySide<TargetId> new_targets(OutlineEdgeId edge) const
    {
        return {new_target_[found_.target_of(edge, Side::negative).number()],
                new_target_[found_.target_of(edge, Side::positive).number()]};
    }

    /// What becomes of each crossing triangle, before any of them moves.
    void number_crossings()
    {
        Index count = 0;
        for (Index i = 0; i < found_.crossings.size(); ++i) {
            const OutlineEdgeId edge = found_.edge_of_crossing(i);
            new_entry_.push_back(is_parted(edge) ? LeafEntry::to_crossing(count++)
                                                 : LeafEntry::to_target(common_target(edge)));
        }
    }

    void rewrite(Index s)
    {
        CutShell& shell = cut_shells_[s];
        rewrite_edges_in_plane(shell);
        rewrite_program(shell);
        rewrite_crossings(s, shell);
    }

    void rewrite_crossings(Index s, CutShell& shell)
    {
        const std::size_t first = crossing_count_;
        for (std::size_t i = shell.first_crossing; i < shell.first_crossing + shell.crossing_count; ++i) {
            if (!new_entry_[i].is_crossing()) continue;
            const BySide<TargetId> targets = new_targets(found_.edge_of_crossing(static_cast<Index>(i)));
            Crossing& c = found_.crossings[crossing_count_++];
            if (&c != &found_.crossings[i]) c = found_.crossings[i];
            c.shell = s;
            c.target = targets;
        }
        shell.first_crossing = first;
        shell.crossing_count = crossing_count_ - first;
    }

    void rewrite_edges_in_plane(CutShell& shell)
    {
        const std::size_t first_flush = flush_.size(), first_in_plane = in_plane_.size();
        for (std::size_t i = shell.first_flush; i < shell.first_flush + shell.flush_count; ++i) {
            FlushEdge e = found_.flush[i];
            e.target = new_target_[e.target.number()];
            e.side = planned_.target(e.target).side;
            flush_.push_back(e);
        }
        for (std::size_t i = shell.first_in_plane; i < shell.first_in_plane + shell.in_plane_count; ++i) {
            const OutlineEdgeId edge = found_.edge_in_plane(static_cast<Index>(i));
            InPlaneEdge e = found_.in_plane[i];
            if (is_parted(edge)) {
                e.shell = new_shell_[e.shell];
                e.target = new_targets(edge);
                in_plane_.push_back(e);
                continue;
            }
            const TargetId target = common_target(edge);
            const bool negative = e.negative_halfedge < e.positive_halfedge;
            flush_.push_back({negative ? e.negative_halfedge : e.positive_halfedge,
                              negative ? e.negative_face : e.positive_face, planned_.target(target).side, target});
        }
        shell.first_flush = first_flush;
        shell.flush_count = flush_.size() - first_flush;
        shell.first_in_plane = first_in_plane;
        shell.in_plane_count = in_plane_.size() - first_in_plane;
    }

    /// What comes to one target in all is handed over in one step: subtrees of paths that are not cut stay as they are.
    void rewrite_program(CutShell& shell)
    {
        const std::size_t first = ops_.size();
        for (std::size_t i = shell.first_op; i < shell.first_op + shell.op_count; ++i) {
            TreeOp op = found_.ops[i];
            if (op.kind == TreeOp::Kind::whole) op = TreeOp::hand_over(op.node, new_target_[op.target().number()]);
            if (op.kind == TreeOp::Kind::leaf) op = rewritten_leaf(op);
            if (op.kind == TreeOp::Kind::join && ops_.size() >= first + 2) {
                // Two children that are handed over whole are the two last steps.
                const TreeOp &left = ops_[ops_.size() - 2], &right = ops_.back();
                if (left.kind == TreeOp::Kind::whole && right.kind == TreeOp::Kind::whole &&
                    left.target() == right.target()) {
                    op = TreeOp::hand_over(op.node, left.target());
                    ops_.resize(ops_.size() - 2);
                }
            }
            ops_.push_back(op);
        }
        shell.first_op = first;
        shell.op_count = ops_.size() - first;
    }

    TreeOp rewritten_leaf(TreeOp op)
    {
        op.counts = {};
        const std::uint32_t count = u_.tree.nodes[op.node].count;
        bool is_uniform = true;
        for (std::uint32_t e = 0; e < count; ++e) {
            LeafEntry& entry = found_.entries[op.argument + e];
            entry = entry.is_crossing() ? new_entry_[entry.crossing()]
                                        : LeafEntry::to_target(new_target_[entry.target().number()]);
            if (entry.is_crossing()) ++op.counts.crossing;
            is_uniform = is_uniform && !entry.is_crossing() && entry == found_.entries[op.argument];
        }
        return is_uniform ? TreeOp::hand_over(op.node, found_.entries[op.argument].target()) : op;
    }

    const Universe& u_;
    const std::vector<ShellRoot>& shells_;
    const std::vector<bool>& is_chosen_;
    const bool split_components_;
    Found& found_;
    Pieces& pieces_;
    JoinedPieces joined_;
    DisjointSets surface_;  // of the targets: those that a triangle which stays whole joins
    BySide<std::vector<ShellRoot>> whole_;
    std::vector<CutShell> cut_shells_;
    std::vector<Index> new_shell_;  ///< of each cut shell; kNone: it stays whole
    Pieces planned_;
    std::vector<TargetId> new_target_;          ///< of each target that was planned
    std::vector<Index> fragment_of_target_;     // of each new target
    std::vector<std::uint32_t> set_of_target_;  // of each new target
    std::vector<bool> is_connected_;            // of each new target
    std::vector<LeafEntry> new_entry_;          ///< of each crossing triangle
    std::size_t crossing_count_ = 0;
    std::vector<TreeOp> ops_;
    std::vector<InPlaneEdge> in_plane_;
    std::vector<FlushEdge> flush_;
};

}  // namespace

std::vector<bool> chosen_edges(const Universe& u, const Plane& plane, const OnlyNear& only, const Found& found,
                               const Section& section)
{
    PlaneSection paths;
    copy_paths(u, found, section, paths);
    const std::vector<bool> is_chosen_path = choose_paths(plane, only, paths);
    std::vector<bool> is_chosen(found.outline_edge_count(), false);
    for (std::size_t i = 0; i < section.loops.size(); ++i)
        for (std::size_t e = 0; e < section.loops[i].count; ++e)
            is_chosen[section.loop_edges[section.loops[i].first + e].number()] = is_chosen_path[i];
    return is_chosen;
}

bool keep_the_rest_whole(const Universe& universe, const std::vector<ShellRoot>& shells,
                         const std::vector<bool>& is_chosen, bool split_components, Found& found, Pieces& pieces)
{
    return PartialCut(universe, shells, is_chosen, split_components, found, pieces).run();
}

}  // namespace kerf::core::halfedge
