#include <algorithm>
#include <cmath>
#include <limits>

#include "halfedge/cap_triangulator.h"

// Ear clipping in layers. An ear is a convex corner whose triangle holds no reflex corner (Meisters 1975: every simple
// polygon has two). A pass over the loop clips every ear that is not next to one that it has clipped already, so edges
// get longer by a constant factor from pass to pass and a line crosses O(log k) triangles on its way in and out, where
// clipping one corner after the other would leave a fan.

namespace kerf::halfedge {

namespace {

struct Point
{
    double x, y;
};

/// Twice the signed area; the sign is right, see cap_halving.cpp.
double turn(const Point& a, const Point& b, const Point& c)
{
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

/// Boxes over the reflex corners of a ring, in runs of eight along the ring and pairs of runs above: a loop is
/// coherent, so its own order is a good tree.
class ReflexTree
{
public:
    void build(const std::vector<Point>& points, const std::vector<std::uint8_t>& reflex)
    {
        leaves_ = (points.size() + kRun - 1) / kRun;
        first_leaf_ = 1;
        while (first_leaf_ < leaves_) first_leaf_ *= 2;
        boxes_.resize(2 * first_leaf_);
        for (std::size_t leaf = 0; leaf < first_leaf_; ++leaf) {
            Box2 box;
            const std::size_t end = std::min(points.size(), (leaf + 1) * kRun);
            for (std::size_t i = leaf * kRun; i < end; ++i)
                if (reflex[i] != 0) box.add(points[i]);
            boxes_[first_leaf_ + leaf] = box;
        }
        for (std::size_t i = first_leaf_ - 1; i > 0; --i) boxes_[i] = boxes_[2 * i].joined(boxes_[2 * i + 1]);
    }

    /// True when a reflex corner other than these three lies in or on the triangle.
    bool meets(const std::vector<Point>& points, const std::vector<std::uint8_t>& reflex, std::size_t ia,
               std::size_t ib, std::size_t ic) const
    {
        const Point &a = points[ia], &b = points[ib], &c = points[ic];
        Box2 box;
        box.add(a);
        box.add(b);
        box.add(c);
        std::array<std::size_t, 64> stack;
        std::size_t depth = 0;
        stack[depth++] = 1;
        while (depth > 0) {
            const std::size_t n = stack[--depth];
            if (!boxes_[n].overlaps(box)) continue;
            if (n < first_leaf_) {
                stack[depth++] = 2 * n;
                stack[depth++] = 2 * n + 1;
                continue;
            }
            const std::size_t begin = (n - first_leaf_) * kRun, end = std::min(points.size(), begin + kRun);
            for (std::size_t i = begin; i < end; ++i) {
                if (reflex[i] == 0 || i == ia || i == ib || i == ic) continue;
                const Point& p = points[i];
                if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return true;
            }
        }
        return false;
    }

private:
    static constexpr std::size_t kRun = 8;

    struct Box2
    {
        double lo_x = std::numeric_limits<double>::infinity(), lo_y = lo_x, hi_x = -lo_x, hi_y = -lo_x;

        void add(const Point& p)
        {
            lo_x = std::min(lo_x, p.x);
            lo_y = std::min(lo_y, p.y);
            hi_x = std::max(hi_x, p.x);
            hi_y = std::max(hi_y, p.y);
        }
        Box2 joined(const Box2& other) const
        {
            Box2 box;
            box.lo_x = std::min(lo_x, other.lo_x);
            box.lo_y = std::min(lo_y, other.lo_y);
            box.hi_x = std::max(hi_x, other.hi_x);
            box.hi_y = std::max(hi_y, other.hi_y);
            return box;
        }
        bool overlaps(const Box2& other) const
        {
            return lo_x <= other.hi_x && other.lo_x <= hi_x && lo_y <= other.hi_y && other.lo_y <= hi_y;
        }
    };

    std::vector<Box2> boxes_;
    std::size_t first_leaf_ = 1, leaves_ = 0;
};

class ClippingTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        const std::size_t n = outline.points.size();
        if (outline.loop_starts.size() != 2 || n < 3) return false;
        cap.clear();
        points_.resize(n);
        ring_.resize(n);
        edge_.resize(n);
        for (Index i = 0; i < n; ++i) {
            points_[i] = {outline.points[i].x, outline.points[i].y};
            ring_[i] = i;
            edge_[i] = kSeamLink + i;
        }
        while (ring_.size() > 3) {
            const std::size_t before = ring_.size();
            clip(cap);
            // Loops that wind like a spiral have few ears at a time; better triangulators know what to do with them.
            constexpr std::size_t kLeastShare = 64;
            const std::size_t clipped = before - ring_.size();
            if (clipped == 0 || clipped * kLeastShare < before) return false;
        }
        // A triangle of no area closes a loop that folds back on itself; it is not worth a special case.
        if (turn(points_[0], points_[1], points_[2]) < 0.0) return false;
        add(cap, 0, 1, 2);
        return true;
    }

private:
    /// One pass. Corners are judged as they are at its beginning: clipping an ear makes no corner reflex, and ears that
    /// are not neighbours don't overlap.
    void clip(CapMesh& cap)
    {
        const std::size_t n = ring_.size();
        reflex_.resize(n);
        for (std::size_t i = 0; i < n; ++i)
            reflex_[i] = turn(points_[i == 0 ? n - 1 : i - 1], points_[i], points_[i + 1 == n ? 0 : i + 1]) <= 0.0;
        reflex_tree_.build(points_, reflex_);

        clipped_.resize(n);
        std::size_t kept = 0;
        bool last_clipped = false, first_clipped = false;
        std::size_t left = n;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t a = i == 0 ? n - 1 : i - 1, c = i + 1 == n ? 0 : i + 1;
            const bool free = !last_clipped && !(i + 1 == n && first_clipped) && left > 3;
            last_clipped = free && reflex_[i] == 0 && !reflex_tree_.meets(points_, reflex_, a, i, c);
            clipped_[i] = last_clipped;
            if (last_clipped) {
                if (i == 0) first_clipped = true;
                --left;
            }
        }
        for (std::size_t i = 0; i < n; ++i) {
            if (clipped_[i] == 0) continue;
            const std::size_t a = i == 0 ? n - 1 : i - 1, c = i + 1 == n ? 0 : i + 1;
            edge_[a] = add_ear(cap, a, i, c);
        }
        for (std::size_t i = 0; i < n; ++i) {
            if (clipped_[i] != 0) continue;
            points_[kept] = points_[i];
            ring_[kept] = ring_[i];
            edge_[kept] = edge_[i];
            ++kept;
        }
        points_.resize(kept);
        ring_.resize(kept);
        edge_.resize(kept);
    }

    void link(CapMesh& cap, Index edge, Index other)
    {
        cap.triangles[edge / 3].link[edge % 3] = other;
        if ((other & kSeamLink) == 0) cap.triangles[other / 3].link[other % 3] = edge;
    }

    /// The triangle over corner b; returns its edge from a to c as seen from the rest of the loop.
    Index add_ear(CapMesh& cap, std::size_t a, std::size_t b, std::size_t c)
    {
        const Index t = static_cast<Index>(cap.triangles.size());
        cap.triangles.push_back({{ring_[a], ring_[b], ring_[c]}, {kNone, kNone, kNone}});
        link(cap, 3 * t, edge_[a]);
        link(cap, 3 * t + 1, edge_[b]);
        return 3 * t + 2;
    }

    void add(CapMesh& cap, std::size_t a, std::size_t b, std::size_t c)
    {
        const Index edge = add_ear(cap, a, b, c);
        link(cap, edge, edge_[c]);
    }

    std::vector<Point> points_;  // of the ring, in its order
    std::vector<Index> ring_;    // their numbers in the outline
    std::vector<Index> edge_;    // what the edge that leaves them is: a seam, or an edge of a triangle
    std::vector<std::uint8_t> reflex_, clipped_;
    ReflexTree reflex_tree_;
};

}  // namespace

std::unique_ptr<CapTriangulator> make_clipping_triangulator()
{
    return std::make_unique<ClippingTriangulator>();
}

}  // namespace kerf::halfedge
