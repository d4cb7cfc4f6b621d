#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/caps/cap_triangulator.h"
#include "common/caps/corner_tree.h"

namespace kerf::core {

/// A ring of corners, counter-clockwise around the inside.
struct Ring
{
    std::vector<glm::dvec2> points;
    std::vector<Index> numbers;  ///< of the corners, for triangles
    std::vector<CapLink> edges;  ///< the edge that leaves each: the outline's, a triangle's, or one of a bridge

    std::size_t size() const { return points.size(); }
    void clear() { resize(0); }
    void resize(std::size_t size)
    {
        points.resize(size);
        numbers.resize(size);
        edges.resize(size);
    }
};

/// Divides rings into triangles by clipping ears. An ear is a convex corner whose triangle holds no reflex corner (Meisters
/// 1975, "Polygons have ears": every simple polygon has two).
///
/// In layers: a pass over the ring clips every ear that is not next to one it has clipped already. So edges get longer by a
/// constant factor from pass to pass, and a line crosses O(log k) triangles on its way in and out; clipping one corner after
/// the other would leave a fan.
///
/// With patience, where few ears are there at a time: clipping an ear changes what its two neighbours are, and no other
/// corner (O'Rourke 1998, "Computational Geometry in C", section 1.6.5), so corners wait in a queue, and come back to it if a
/// neighbour was clipped.
///
/// A corner at which the ring runs straight back upon itself is an ear, too, of a triangle without area: points along a
/// straight edge of a piece may be out of order by a rounding.
///
/// Triangles that all run counter-clockwise cover a place as often as the ring winds around it, since their edges are those
/// of the ring: a corner that is taken for an ear and is none can stop the clipping, and do no other harm. Only the last
/// triangle may be turned over, by no more than the rounding of its corners: where the tip of a wedge is as thin as that,
/// they may have changed places (kTurnedByRounding).
class EarClipper
{
public:
    /// The ring to be clipped, for the caller to fill in; it is used up.
    Ring& ring() { return ring_; }

    /// In layers alone. No corners may share a place. The triangles are added to `cap`. False if ears are too few, or after
    /// so many looks at corners; they are counted down. O(k log k).
    bool clip_in_layers(CapMesh& cap, std::uint64_t& looks_left);

    /// In layers as long as there are ears enough, then with patience. Corners may share a place with others: bridges make
    /// such, and loops that touch. False if no ear is left, or after so many looks.
    bool clip_with_patience(CapMesh& cap, std::uint64_t& looks_left);

private:
    /// False if ears were few, or none.
    bool clip_layer(CapMesh& cap);
    /// Until half of the ring is left, or there is no ear. False if there was none.
    bool clip_one_by_one(CapMesh& cap);
    void keep_what_is_left();
    void link_corners();
    void clip_corner(Index b, CapMesh& cap);
    void wait(Index i);
    bool is_left(Index i) const { return after_[i] != i; }
    /// What a corner may be.
    enum class Corner : std::uint8_t
    {
        convex,
        reflex,  ///< or straight on
        folded,  ///< straight back: it may be an ear, and it may lie in one
    };
    Corner corner_between(std::size_t a, std::size_t b, std::size_t c) const;
    /// Whether no corner that is not convex, other than these three, lies in or on their triangle; no if no look is left.
    /// `corner_at(i)` is the corner of item i of the tree.
    template <class CornerAt>
    bool is_ear(std::size_t a, std::size_t b, std::size_t c, CornerAt corner_at);
    CapLink add_triangle(CapMesh& cap, std::size_t a, std::size_t b, std::size_t c);
    bool add_last_triangle(CapMesh& cap);
    bool is_turned_by_rounding(double twice_area) const;

    Ring ring_;
    std::vector<Corner> corners_;
    std::vector<std::uint8_t> clipped_;
    CornerTree tree_;  // of the corners that are not convex
    bool places_may_repeat_ = false;
    /// A layer of less than one of so many corners is few ears: rings that wind like a spiral have few at a time. With
    /// patience fewer layers are worth a pass over the ring.
    std::size_t least_share_ = 0;
    std::uint64_t looks_left_ = 0;
    // With patience
    std::vector<Index> before_, after_;  // of each corner that is left; one that was clipped follows itself
    std::vector<std::uint8_t> is_waiting_;
    std::vector<Index> queue_;
    std::vector<Index> order_;  // of the corners that were not convex at the beginning
};

}  // namespace kerf::core
