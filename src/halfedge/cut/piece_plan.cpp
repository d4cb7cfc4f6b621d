#include "halfedge/cut/piece_plan.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "common/cutting/pieces.h"
#include "common/geometry/disjoint_sets.h"
#include "halfedge/cut/outline.h"
#include "halfedge/cut/parts_of_side.h"

namespace kerf::halfedge {

namespace {

/// The outline as group_pieces() wants it.
struct PiecesOutline
{
    std::vector<glm::vec3> points;
    std::vector<OutlineEdge> edges;
};

PiecesOutline outline_of(const Universe& u, const CutScratch& s, BySide<PartsOfSide>& sides)
{
    PiecesOutline outline;
    const auto bound = [&](OutlineEdge& edge, OutlineEdgeId outline_edge) {
        for (const Side side : kSides) {
            edge.part[side] = kNoPart;
            if (s.bounds_nothing(outline_edge, side)) continue;
            edge.part[side] = sides[side].of_target(s.target_of(outline_edge, side));
            sides[side].mark_cut(edge.part[side]);
        }
    };
    if (s.irregular) {
        outline.points = s.outline_points;
        outline.edges = outline_edges(u, s);
        for (std::size_t i = 0; i < s.outline.size(); ++i) bound(outline.edges[i], s.outline[i].id);
        return outline;
    }
    const auto add = [&](OutlineEdgeId outline_edge, Index from, Index to) {
        bound(outline.edges.emplace_back(OutlineEdge{from, to, {}, s.source_of(u, outline_edge)}), outline_edge);
    };
    outline.points = s.loop_points;
    for (const Loop& loop : s.loops) {
        const auto first = static_cast<Index>(loop.first), last = static_cast<Index>(loop.first + loop.count - 1);
        for (Index i = first; i < last; ++i) add(s.loop_edges[i], i, i + 1);
        Index end = first;
        if (!loop.closed) {
            end = static_cast<Index>(outline.points.size());
            outline.points.push_back(loop.end);
        }
        add(s.loop_edges[last], last, end);
    }
    return outline;
}

}  // namespace

PiecePlan plan_sides(const BySide<std::vector<ShellRoot>>& whole, CutScratch& s)
{
    PiecePlan plan;
    for (const Side side : kSides) {
        plan.whole_fragment[side].assign(whole[side].size(), 0);
        plan.fragment_count[side] = whole[side].empty() && s.targets.empty() ? 0 : 1;
    }
    // Piece shells come in pairs: negative, positive.
    std::unordered_map<std::uint32_t, Index> piece_shell_of_solid;
    for (Target& t : s.targets) {
        const CutShell& shell = s.cut_shells[t.shell];
        const auto [entry, is_new] =
            piece_shell_of_solid.try_emplace(shell.solid, static_cast<Index>(s.piece_shells.size()));
        if (is_new)
            for (const Side side : kSides) {
                PieceShell b;
                b.side = side;
                b.solid = shell.solid;
                b.shell = t.shell;
                // One curve on a connected shell leaves one part on each side, whatever the shell's genus.
                b.connected = shell.connected && shell.loops == 1 && s.loops_are_all_curves();
                s.piece_shells.push_back(b);
            }
        t.piece_shell = entry->second + static_cast<Index>(t.side);
        // Whether caps connect several shells of a solid is not looked into.
        PieceShell& b = s.piece_shells[t.piece_shell];
        b.connected = b.connected && b.shell == t.shell;
    }
    return plan;
}

PiecePlan plan_pieces(const Universe& universe, const Plane& plane, const BySide<std::vector<ShellRoot>>& whole,
                      CutScratch& s)
{
    BySide<PartsOfSide> sides{PartsOfSide(universe, plane, Side::negative, whole[Side::negative], s),
                              PartsOfSide(universe, plane, Side::positive, whole[Side::positive], s)};
    DisjointSets same(static_cast<std::uint32_t>(s.targets.size()));
    if (s.irregular && s.targets.size() > 2 * s.cut_shells.size())
        for (const auto& [a, b] : targets_that_share_edges(universe, s)) same.unite(a, b);
    if (s.irregular && universe.has_boundary) find_edges_that_bound_nothing(universe, s);
    for (PartsOfSide& side : sides) side.list(same);
    const PiecesOutline outline = outline_of(universe, s, sides);
    for (PartsOfSide& side : sides) side.measure();

    BySide<SideParts> input;
    for (const Side side : kSides)
        input[side] = {sides[side].parts(),
                       [&parts = sides[side]](std::span<const AxisRay> rays, const std::vector<bool>& is_wanted,
                                              const AddCrossing& add) { parts.count_crossings(rays, is_wanted, add); }};
    const BySide<std::vector<std::uint32_t>> piece = group_pieces(plane, input, outline.points, outline.edges);
    PiecePlan plan;
    for (const Side side : kSides)
        plan.fragment_count[side] = sides[side].make_piece_shells(piece[side], s, plan.whole_fragment[side]);
    if (s.irregular) relink_outline(universe, plane, s);
    return plan;
}

void plan_cap_sets(CutScratch& s)
{
    std::map<BySide<Index>, Index> sets;
    for (Loop& loop : s.loops)
        loop.cap_set = sets.try_emplace(s.piece_shells_of(s.loop_edges[loop.first]), Index(sets.size())).first->second;
}

void hand_out_caps(CutScratch& s)
{
    std::vector<BySide<Index>> piece_shells_of_set;
    for (const Loop& loop : s.loops) {
        if (loop.cap_set >= piece_shells_of_set.size()) piece_shells_of_set.resize(loop.cap_set + 1);
        piece_shells_of_set[loop.cap_set] = s.piece_shells_of(s.loop_edges[loop.first]);
    }
    s.cap_piece_shell.resize(s.caps.size());
    for (const CapSet& cap : s.cap_sets) {
        const BySide<Index> piece_shells = piece_shells_of_set[cap.set];
        for (std::size_t t = cap.first; t < cap.first + cap.count; ++t) s.cap_piece_shell[t] = piece_shells;
        for (const Index piece_shell : piece_shells)
            s.piece_shells[piece_shell].cap_count += static_cast<std::uint32_t>(cap.count);
    }
}

void divide_piece_shells(CutScratch& s)
{
    const auto targets = static_cast<std::uint32_t>(s.targets.size()), caps = static_cast<std::uint32_t>(s.caps.size());
    std::vector<std::uint32_t> targets_in(s.piece_shells.size(), 0);
    for (const Target& t : s.targets) ++targets_in[t.piece_shell];
    if (std::none_of(targets_in.begin(), targets_in.end(), [](std::uint32_t count) { return count > 1; })) return;

    // Targets, then the caps of either side.
    DisjointSets joined(targets + 2 * caps);
    const auto cap_number = [&](Side side, Index t) { return targets + static_cast<std::uint32_t>(side) * caps + t; };
    for (const Side side : kSides) {
        for (std::uint32_t t = 0; t < caps; ++t)
            for (const CapLink link : s.caps[t].link)
                joined.unite(cap_number(side, t), link.is_outline()
                                                      ? s.target_of(s.loop_edges[link.outline_edge()], side)
                                                      : cap_number(side, link.triangle()));
        for (const auto& [a, b] : s.cancelled) joined.unite(s.target_of(a, side), s.target_of(b, side));
    }
    // The first target of a piece shell keeps it together with all that is connected with it.
    std::vector<Index> first(s.piece_shells.size(), kNone), piece_shell_of_set(targets, kNone);
    for (Index t = 0; t < targets; ++t) {
        const Index set = joined.find(t), old = s.targets[t].piece_shell;
        if (first[old] == kNone) {
            first[old] = t;
            piece_shell_of_set[set] = old;
        }
        if (piece_shell_of_set[set] == kNone) {
            piece_shell_of_set[set] = static_cast<Index>(s.piece_shells.size());
            PieceShell b = s.piece_shells[old];
            b.cap_count = 0;
            s.piece_shells.push_back(b);
        }
        s.targets[t].piece_shell = piece_shell_of_set[set];
    }
    for (const Side side : kSides)
        for (std::uint32_t t = 0; t < caps; ++t) {
            Index& piece_shell = s.cap_piece_shell[t][side];
            --s.piece_shells[piece_shell].cap_count;
            piece_shell = piece_shell_of_set[joined.find(cap_number(side, t))];
            ++s.piece_shells[piece_shell].cap_count;
        }
}

}  // namespace kerf::halfedge
