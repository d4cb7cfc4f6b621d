#pragma once

#include <cstdint>

#include "common/mesh/side.h"
#include "halfedge/cut/crossing.h"
#include "halfedge/universe/ids.h"

// The program that rebuilds a tree: which of its parts go where.

namespace kerf::core::halfedge {

/// The target that a side of a cut shell has before it is known whether the side falls apart.
inline TargetId first_target(Index shell, Side side)
{
    return TargetId(2 * shell + static_cast<Index>(side));
}

/// The side of such a target.
inline Side side_of_target(TargetId first_target)
{
    return static_cast<Side>(first_target.number() % 2);
}

/// What FIND counts in a leaf that is rewritten.
struct LeafCounts
{
    std::uint8_t crossing = 0;       ///< triangles that cross: so many of Found::crossings, in the order of the program
    BySide<std::uint8_t> kept{};     ///< others, by the side that they are kept on
    bool sides_are_targets = false;  ///< everything goes to the first target of its side
};

/// A step of the program that rebuilds a tree, in post-order: FIND writes it, REBUILD runs it once.
struct TreeOp
{
    enum class Kind : std::uint8_t
    {
        whole,  ///< hand over subtree `node` to target `argument`
        leaf,   ///< rewrite leaf `node`; its entries start at `argument`
        join,   ///< combine the results of the two children of inner node `node`
    };
    Kind kind;
    NodeId node;
    Index argument;
    LeafCounts counts = {};

    static TreeOp hand_over(NodeId node, TargetId target) { return {Kind::whole, node, target.number()}; }
    TargetId target() const { return TargetId(argument); }
};

}  // namespace kerf::core::halfedge
