#include "common/repair/vertex_fans.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "common/geometry/disjoint_sets.h"
#include "common/mesh/index.h"

namespace kerf::core {

namespace {

/// Collects the corners of a fan one by one: counter-clockwise, then, if the fan is open, clockwise.
class FanWalk
{
public:
    void start(std::uint32_t corner)
    {
        corners_.assign(1, corner);
        forward_ = true;
    }

    /// Takes one more corner; false if there is none.
    bool step(const LinkedSurface& surface)
    {
        const std::uint32_t first = corners_.front();
        if (forward_) {
            const std::uint32_t corner = surface.opposite[previous_halfedge(corners_.back())];
            if (corner == first) return false;
            if (corner != kNone) {
                corners_.push_back(corner);
                return true;
            }
            forward_ = false;
            clockwise_ = first;
        }
        const std::uint32_t across = surface.opposite[clockwise_];
        if (across == kNone) return false;
        clockwise_ = next_halfedge(across);
        corners_.push_back(clockwise_);
        return true;
    }

    const std::vector<std::uint32_t>& corners() const { return corners_; }

private:
    std::vector<std::uint32_t> corners_;
    bool forward_ = true;
    std::uint32_t clockwise_ = 0;
};

/// Divides fans. The smaller of two parts gets a new label, whichever number it is to have, so that a corner changes
/// its label O(log n) times; finish() replaces labels by numbers.
class FanDivider
{
public:
    FanDivider(LinkedSurface& surface, VertexFans& fans) : surface_(surface), fans_(fans) {}

    /// Exchanging the partners of two links on the same cycle divides the cycle in two, and never joins two fans. So
    /// half-edges between the same two fans are a strand, strands only fall apart, and one pass over each edge is enough.
    void separate_repeats(const NonmanifoldEdge& edge)
    {
        edge_ = &edge;
        next_.assign(edge.size(), kNone);
        previous_.assign(edge.size(), kNone);
        moved_.resize(edge.size());
        std::iota(moved_.begin(), moved_.end(), 0u);
        form_strands();
        bool placed = false;
        for (std::uint32_t i = 0; i < edge.size(); ++i)
            while (next_[i] != kNone) {
                if (!placed) note_places(edge);
                placed = true;
                exchange(i, next_[i]);
            }
        if (placed)
            for (const std::uint32_t h : edge) place_[h] = kNone;
    }

    void finish()
    {
        if (number_.empty()) return;
        for (std::uint32_t& fan : fans_.fan) fan = number_[fan];
    }

private:
    /// Makes strands, as lists in ascending order, of `moved_`: places in the edge that are in no strand and whose fans
    /// hold no half-edge of another strand.
    void form_strands()
    {
        const auto key = [&](std::uint32_t place) {
            const std::uint32_t h = (*edge_)[place];
            return std::array{fans_.fan[h], fans_.fan[next_halfedge(h)]};
        };
        std::sort(moved_.begin(), moved_.end(), [&](std::uint32_t a, std::uint32_t b) {
            ++fans_.steps;
            const auto key_a = key(a), key_b = key(b);
            return key_a != key_b ? key_a < key_b : a < b;
        });
        moved_.erase(std::unique(moved_.begin(), moved_.end()), moved_.end());
        for (std::size_t i = 1; i < moved_.size(); ++i) {
            const std::uint32_t before = moved_[i - 1], after = moved_[i];
            if (key(before) != key(after)) continue;
            next_[before] = after;
            previous_[after] = before;
        }
    }

    void note_places(const NonmanifoldEdge& edge)
    {
        if (place_.empty()) place_.assign(surface_.opposite.size(), kNone);
        for (std::uint32_t i = 0; i < edge.size(); ++i) place_[edge[i]] = i;
    }

    void exchange(std::uint32_t i, std::uint32_t j)
    {
        const std::uint32_t a = (*edge_)[i], b = (*edge_)[j];
        const std::uint32_t across_a = surface_.opposite[a], across_b = surface_.opposite[b];
        surface_.opposite[a] = surface_.opposite[b] = kNone;
        surface_.link(a, across_b);
        surface_.link(b, across_a);
        moved_.clear();
        divide(a, b);
        divide(next_halfedge(a), next_halfedge(b));
        form_strands();
    }

    /// Labels the two parts of a fan, with corners `a` and `b`; the part of `a` gets a new number.
    void divide(std::uint32_t a, std::uint32_t b)
    {
        if (number_.empty()) {
            number_.resize(fans_.count);
            std::iota(number_.begin(), number_.end(), 0u);
        }
        walk_a_.start(a);
        walk_b_.start(b);
        bool a_is_smaller = false;
        for (;; fans_.steps += 2) {
            a_is_smaller = !walk_a_.step(surface_);
            if (a_is_smaller || !walk_b_.step(surface_)) break;
        }
        const std::uint32_t label = fans_.count++;
        number_.push_back(label);
        if (!a_is_smaller) std::swap(number_[label], number_[fans_.fan[a]]);
        for (const std::uint32_t corner : (a_is_smaller ? walk_a_ : walk_b_).corners()) {
            fans_.fan[corner] = label;
            leave_group(corner);
            leave_group(previous_halfedge(corner));
        }
    }

    void leave_group(std::uint32_t halfedge)
    {
        const std::uint32_t place = place_[halfedge];
        if (place == kNone) return;
        const std::uint32_t before = std::exchange(previous_[place], kNone), after = std::exchange(next_[place], kNone);
        if (before != kNone) next_[before] = after;
        if (after != kNone) previous_[after] = before;
        moved_.push_back(place);
    }

    LinkedSurface& surface_;
    VertexFans& fans_;
    std::vector<std::uint32_t> number_;  // for each label; empty: labels are numbers
    FanWalk walk_a_, walk_b_;
    // Of one edge: places in its list of half-edges.
    const NonmanifoldEdge* edge_ = nullptr;
    std::vector<std::uint32_t> next_, previous_;  // in the place's strand
    std::vector<std::uint32_t> moved_;
    Buffer<std::uint32_t> place_;  // of each half-edge of the surface
};

}  // namespace

VertexFans find_vertex_fans(LinkedSurface& surface, std::span<const NonmanifoldEdge> resolved,
                            std::span<std::uint8_t> is_used)
{
    VertexFans fans;
    fans.fan.assign(surface.opposite.size(), kNone);
    for (std::uint32_t h = 0; h < surface.opposite.size(); ++h) {
        if (fans.fan[h] != kNone) continue;
        const std::uint32_t number = fans.count++;
        if (!is_used.empty()) is_used[surface.start(h)] = 1;
        std::uint32_t corner = h;
        do {
            fans.fan[corner] = number;
            corner = surface.opposite[previous_halfedge(corner)];
        } while (corner != kNone && corner != h);
        if (corner == h) continue;
        for (std::uint32_t across = surface.opposite[h]; across != kNone; across = surface.opposite[corner]) {
            corner = next_halfedge(across);
            fans.fan[corner] = number;
        }
    }
    if (resolved.empty()) return fans;
    FanDivider divider(surface, fans);
    for (const NonmanifoldEdge& edge : resolved) divider.separate_repeats(edge);
    divider.finish();
    return fans;
}

std::uint64_t count_nonmanifold_points(std::uint32_t point_count, std::span<const Triangle> corners,
                                       HalfedgesByEdge& edges)
{
    // Corner i of triangle t is number 3t + i, like the half-edge that starts there.
    DisjointSets fans(static_cast<std::uint32_t>(corners.size() * 3));
    const auto point_at = [&](std::uint32_t corner) { return start_of(corners, corner); };
    edges.for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
        const std::uint32_t first = edge[0].halfedge;
        for (const HalfedgesByEdge::Entry& entry : edge.subspan(1)) {
            std::uint32_t start = entry.halfedge, end = next_halfedge(start);
            if (point_at(start) != point_at(first)) std::swap(start, end);
            fans.unite(first, start);
            fans.unite(next_halfedge(first), end);
        }
    });

    Buffer<std::uint32_t> fans_at(point_count, 0);
    for (std::uint32_t corner = 0; corner < corners.size() * 3; ++corner)
        if (fans.find(corner) == corner) ++fans_at[point_at(corner)];
    return static_cast<std::uint64_t>(
        std::count_if(fans_at.begin(), fans_at.end(), [](std::uint32_t n) { return n > 1; }));
}

}  // namespace kerf::core
