#include "halfedge/cut/piece_plan.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "common/cutting/group_pieces.h"
#include "common/geometry/disjoint_sets.h"
#include "halfedge/cut/irregular/irregular.h"
#include "halfedge/cut/measure_parts.h"

namespace kerf::core::halfedge {

namespace {

/// The outline as group_pieces() wants it.
struct PiecesOutline
{
    std::vector<glm::vec3> points;
    std::vector<OutlineEdge> edges;
};

PiecesOutline outline_of(const Universe& u, const Found& found, const Section& section, BySide<PartsOfSide>& sides)
{
    PiecesOutline outline;
    const auto bound = [&](OutlineEdge& edge, OutlineEdgeId outline_edge) {
        for (const Side side : kSides) {
            edge.part[side] = kNoPart;
            if (found.bounds_nothing(outline_edge, side)) continue;
            edge.part[side] = sides[side].of_target(found.target_of(outline_edge, side));
            sides[side].mark_cut(edge.part[side]);
        }
    };
    if (section.is_irregular()) {
        outline.points = section.outline_points;
        list_outline_edges(u, found, section, outline.edges);
        for (std::size_t i = 0; i < section.outline.size(); ++i) bound(outline.edges[i], section.outline[i].id);
        return outline;
    }
    const auto add = [&](OutlineEdgeId outline_edge, Index from, Index to) {
        bound(outline.edges.emplace_back(OutlineEdge{from, to, {}, found.source_of(u, outline_edge)}), outline_edge);
    };
    outline.points = section.loop_points;
    for (const Loop& loop : section.loops) {
        const auto first = static_cast<Index>(loop.first), last = static_cast<Index>(loop.first + loop.count - 1);
        for (Index i = first; i < last; ++i) add(section.loop_edges[i], i, i + 1);
        Index end = first;
        if (!loop.closed) {
            end = static_cast<Index>(outline.points.size());
            outline.points.push_back(loop.end);
        }
        add(section.loop_edges[last], last, end);
    }
    return outline;
}

/// Whether all that is cut is one shell that falls into one part a side, and nothing else is there: most cuts of a game.
/// Then the pieces divide an irregular outline no further than OutlineLinker::link() has done by solid, unless edges at a
/// boundary bound nothing.
bool is_one_part_a_side(const Universe& universe, const Found& found, const Section& section, const Pieces& pieces)
{
    const bool is_linked = !section.is_irregular() || !universe.has_boundary;
    return is_linked && pieces.targets.size() == 2 && found.whole[Side::negative].empty() &&
           found.whole[Side::positive].empty() &&
           std::none_of(pieces.targets.begin(), pieces.targets.end(), [](const Target& t) { return t.is_empty; });
}

/// What group_pieces() would say of it.
void make_one_piece_a_side(const Found& found, Pieces& pieces)
{
    for (const Side side : kSides) {
        PieceShell made;
        made.side = side;
        made.solid = found.shells.front().solid;
        pieces.target(first_target(0, side)).piece_shell = static_cast<Index>(pieces.shells.size());
        pieces.shells.push_back(made);
        pieces.whole_fragment[side].clear();
        pieces.fragment_count[side] = 1;
    }
}

}  // namespace

void make_first_targets(const Found& found, Pieces& pieces)
{
    for (Index i = 0; i < found.shells.size(); ++i)
        for (const Side side : kSides) {
            Target t;
            t.side = side;
            t.shell = i;
            pieces.targets.push_back(t);
        }
}

void plan_sides(const Found& found, const Section& section, Pieces& pieces)
{
    for (const Side side : kSides) {
        pieces.whole_fragment[side].assign(found.whole[side].size(), 0);
        pieces.fragment_count[side] = found.whole[side].empty() && pieces.targets.empty() ? 0 : 1;
    }
    // Piece shells come in pairs: negative, positive.
    std::unordered_map<std::uint32_t, Index> piece_shell_of_solid;
    for (Target& t : pieces.targets) {
        const CutShell& shell = found.shells[t.shell];
        const auto [entry, is_new] =
            piece_shell_of_solid.try_emplace(shell.solid, static_cast<Index>(pieces.shells.size()));
        if (is_new)
            for (const Side side : kSides) {
                PieceShell made;
                made.side = side;
                made.solid = shell.solid;
                made.shell = t.shell;
                // One curve on a connected shell leaves one part on each side, whatever the shell's genus.
                made.connected =
                    shell.connected && section.loops_on_shell[t.shell] == 1 && section.loops_are_all_curves();
                pieces.shells.push_back(made);
            }
        t.piece_shell = entry->second + static_cast<Index>(t.side);
        // Whether caps connect several shells of a solid is not looked into.
        PieceShell& made = pieces.shells[t.piece_shell];
        made.connected = made.connected && made.shell == t.shell;
    }
}

void plan_pieces(const Universe& universe, const Plane& plane, Found& found, OutlineLinker& linker, Section& section,
                 Pieces& pieces)
{
    if (is_one_part_a_side(universe, found, section, pieces)) return make_one_piece_a_side(found, pieces);
    BySide<PartsOfSide> sides{PartsOfSide(universe, plane, Side::negative, found, pieces),
                              PartsOfSide(universe, plane, Side::positive, found, pieces)};
    DisjointSets same(static_cast<std::uint32_t>(pieces.targets.size()));
    if (section.is_irregular() && pieces.targets.size() > 2 * found.shells.size())
        for (const auto& [a, b] : targets_that_share_edges(universe, found, section))
            same.unite(a.number(), b.number());
    if (section.is_irregular() && universe.has_boundary) find_edges_that_bound_nothing(universe, section, found);
    for (PartsOfSide& side : sides) side.list(same);
    const PiecesOutline outline = outline_of(universe, found, section, sides);
    for (PartsOfSide& side : sides) side.measure();

    BySide<SideParts> input;
    for (const Side side : kSides)
        input[side] = {sides[side].parts(),
                       [&parts = sides[side]](std::span<const AxisRay> rays, const std::vector<bool>& is_wanted,
                                              const AddCrossing& add) { parts.count_crossings(rays, is_wanted, add); }};
    const BySide<std::vector<std::uint32_t>> piece = group_pieces(plane, input, outline.points, outline.edges);
    for (const Side side : kSides) sides[side].make_piece_shells(piece[side], pieces);
    if (section.is_irregular()) linker.relink(universe, plane, found, pieces, section);
}

void plan_cap_sets(const Found& found, const Pieces& pieces, Section& section)
{
    if (section.loops.size() == 1) {
        section.loops.front().cap_set = 0;
        return;
    }
    std::map<BySide<Index>, Index> sets;
    for (Loop& loop : section.loops)
        loop.cap_set =
            sets.try_emplace(pieces.shells_of(found, section.loop_edges[loop.first]), Index(sets.size())).first->second;
}

void hand_out_caps(const Found& found, const Section& section, Caps& caps, Pieces& pieces)
{
    std::vector<BySide<Index>> piece_shells_of_set;
    for (const Loop& loop : section.loops) {
        if (loop.cap_set >= piece_shells_of_set.size()) piece_shells_of_set.resize(loop.cap_set + 1);
        piece_shells_of_set[loop.cap_set] = pieces.shells_of(found, section.loop_edges[loop.first]);
    }
    caps.piece_shells.resize(caps.triangles.size());
    for (const CapSet& cap : caps.sets) {
        const BySide<Index> piece_shells = piece_shells_of_set[cap.set];
        for (std::size_t t = cap.first; t < cap.first + cap.count; ++t) caps.piece_shells[t] = piece_shells;
        for (const Index piece_shell : piece_shells)
            pieces.shells[piece_shell].cap_count += static_cast<std::uint32_t>(cap.count);
    }
}

void divide_piece_shells(const Found& found, const Section& section, Caps& caps, Pieces& pieces)
{
    const auto target_count = static_cast<std::uint32_t>(pieces.targets.size());
    const auto cap_count = static_cast<std::uint32_t>(caps.triangles.size());
    // A piece shell has at least one target.
    if (target_count == pieces.shells.size()) return;

    // Targets, then the caps of either side.
    DisjointSets joined(target_count + 2 * cap_count);
    const auto cap_number = [&](Side side, Index t) {
        return target_count + static_cast<std::uint32_t>(side) * cap_count + t;
    };
    for (const Side side : kSides) {
        for (std::uint32_t t = 0; t < cap_count; ++t)
            for (const CapLink link : caps.triangles[t].link)
                joined.unite(cap_number(side, t),
                             link.is_outline() ? found.target_of(section.loop_edges[link.outline_edge()], side).number()
                                               : cap_number(side, link.triangle()));
        for (const auto& [a, b] : section.cancelled)
            joined.unite(found.target_of(a, side).number(), found.target_of(b, side).number());
    }
    // The first target of a piece shell keeps it together with all that is connected with it.
    std::vector<Index> first(pieces.shells.size(), kNone), piece_shell_of_set(target_count, kNone);
    for (Index t = 0; t < target_count; ++t) {
        const Index set = joined.find(t), old = pieces.targets[t].piece_shell;
        if (first[old] == kNone) {
            first[old] = t;
            piece_shell_of_set[set] = old;
        }
        if (piece_shell_of_set[set] == kNone) {
            piece_shell_of_set[set] = static_cast<Index>(pieces.shells.size());
            PieceShell made = pieces.shells[old];
            made.cap_count = 0;
            pieces.shells.push_back(made);
        }
        pieces.targets[t].piece_shell = piece_shell_of_set[set];
    }
    for (const Side side : kSides)
        for (std::uint32_t t = 0; t < cap_count; ++t) {
            Index& piece_shell = caps.piece_shells[t][side];
            --pieces.shells[piece_shell].cap_count;
            piece_shell = piece_shell_of_set[joined.find(cap_number(side, t))];
            ++pieces.shells[piece_shell].cap_count;
        }
}

}  // namespace kerf::core::halfedge
