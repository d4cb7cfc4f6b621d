#pragma once

#include <cstdint>
#include <vector>

#include "halfedge/cut/find.h"

// From an object to its fragments:
//
//   shell of the object   that the plane meets: a CutShell, with a program of TreeOps that takes its tree apart
//     Target              one side of a cut shell, or a connected part of that side: where triangles go
//       PieceShell        targets that caps or touching edges join: a shell of a fragment
//         fragment        piece shells of one side (or of one piece, if the caller asks for pieces), and whole shells

namespace kerf::core::halfedge {

/// A connected part of one side of a cut shell: where triangles go. Each side of each cut shell has a first_target();
/// if a side falls apart there are more behind them.
struct Target
{
    Side side = Side::negative;
    Index shell = 0;          ///< of the cut shells
    bool is_empty = false;    ///< all that would be in it has vanished
    Index piece_shell = 0;    ///< what it is joined with
    std::uint32_t count = 0;  ///< rewritten triangles
    SlotId cursor;            ///< next slot to write
    NodeId root;
};

/// Targets of one piece: a shell of a fragment.
struct PieceShell
{
    Side side = Side::negative;
    std::uint32_t solid = 0;
    Index shell = 0;     ///< the first of the cut shells in it
    Index fragment = 0;  ///< index in the side's fragments
    bool connected = true;
    NodeId root;
    GroupId cap_group;  ///< of its caps
    std::uint32_t cap_count = 0;
    SlotId cap_first, cap_cursor;
};

/// Which fragment everything goes to.
struct Pieces
{
    std::vector<Target> targets;
    std::vector<PieceShell> shells;
    BySide<Index> fragment_count{};
    BySide<std::vector<Index>> whole_fragment;  ///< of each shell that is not cut

    Target& target(TargetId t) { return targets[t.number()]; }
    const Target& target(TargetId t) const { return targets[t.number()]; }
    TargetId add(const Target& target)
    {
        targets.push_back(target);
        return TargetId(static_cast<Index>(targets.size() - 1));
    }

    void clear()
    {
        targets.clear();
        shells.clear();
        for (const Side side : kSides) {
            fragment_count[side] = 0;
            whole_fragment[side].clear();
        }
    }

    /// The piece shells that an outline edge lies between.
    BySide<Index> shells_of(const Found& found, OutlineEdgeId edge) const
    {
        return {target(found.target_of(edge, Side::negative)).piece_shell,
                target(found.target_of(edge, Side::positive)).piece_shell};
    }
};

}  // namespace kerf::core::halfedge
