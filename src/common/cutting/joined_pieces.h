#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/disjoint_sets.h"
#include "common/mesh/side.h"

namespace kerf::core {

/// What stays together of a cut's pieces if the cut is made along some of its outline only: two pieces that lie on both
/// sides of an outline edge which is not cut are one. Both back ends say of each outline edge what becomes of it, in any
/// order, and get the same answer.
class JoinedPieces
{
public:
    /// @param count  pieces on each side
    explicit JoinedPieces(const BySide<std::uint32_t>& count);

    /// A piece, and the side of the whole cut that it lies on.
    struct Piece
    {
        Side side = Side::negative;
        std::uint32_t number = 0;
    };

    /// Two pieces on both sides of an outline edge that is not cut.
    void join(const Piece& a, const Piece& b) { joined_.unite(node(a.side, a.number), node(b.side, b.number)); }
    void join(const BySide<std::uint32_t>& pieces)
    {
        join({Side::negative, pieces[Side::negative]}, {Side::positive, pieces[Side::positive]});
    }
    /// One that is cut.
    void part(const BySide<std::uint32_t>& pieces);

    /// Once all edges are known: numbers what stays together, on each side from 0 on, in the order of its first piece. What
    /// no cut edge bounds goes to the negative side, unless it lies on the positive side of the plane. Returns false if a
    /// cut edge lies within something that stays together, or between two things that would be on both sides. O(pieces +
    /// edges that are cut).
    bool find();

    /// Where a piece comes to.
    struct Place
    {
        Side side = Side::negative;
        std::uint32_t number = 0;
        friend bool operator==(const Place&, const Place&) = default;
    };
    Place place_of(Side side, std::uint32_t piece) const { return places_[node(side, piece)]; }
    std::uint32_t count(Side side) const { return counts_[side]; }

private:
    std::uint32_t node(Side side, std::uint32_t piece) const
    {
        return side == Side::negative ? piece : pieces_[Side::negative] + piece;
    }

    BySide<std::uint32_t> pieces_;
    DisjointSets joined_;
    std::vector<BySide<std::uint32_t>> cut_;  ///< pairs of nodes
    std::vector<Place> places_;               ///< of each node
    BySide<std::uint32_t> counts_{};
};

}  // namespace kerf::core
