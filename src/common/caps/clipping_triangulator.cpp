#include "common/caps/clipping_triangulator.h"

#include "common/caps/loop_boxes.h"
#include "common/geometry/turn.h"

// Ear clipping in layers. An ear is a convex corner whose triangle holds no reflex corner (Meisters 1975: every simple
// polygon has two). A pass over the loop clips every ear that is not next to one it has clipped already. So edges get
// longer by a constant factor from pass to pass, and a line crosses O(log k) triangles on its way in and out; clipping
// one corner after the other would leave a fan.

namespace kerf::core {

namespace {

/// The reflex corners of a ring.
class ReflexTree
{
public:
    void build(const std::vector<glm::dvec2>& points, const std::vector<std::uint8_t>& reflex)
    {
        boxes_.build(points.size(), [&](std::size_t i, Box2& box) {
            if (reflex[i] != 0) box.add(points[i].x, points[i].y);
        });
    }

    /// True if a reflex corner other than these three lies in or on the triangle. Counts the corners that it looks at
    /// down from `left`, and is true if none are left.
    bool meets(const std::vector<glm::dvec2>& points, const std::vector<std::uint8_t>& reflex, std::size_t ia,
               std::size_t ib, std::size_t ic, std::size_t& left) const
    {
        const glm::dvec2 &a = points[ia], &b = points[ib], &c = points[ic];
        Box2 box;
        for (const glm::dvec2* p : {&a, &b, &c}) box.add(p->x, p->y);
        return boxes_.any(box, [&](std::size_t i) {
            if (left == 0) return true;
            --left;
            if (reflex[i] == 0 || i == ia || i == ib || i == ic) return false;
            const glm::dvec2& p = points[i];
            return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
        });
    }

private:
    LoopBoxes boxes_;
};

class ClippingTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        cap.clear();
        const std::size_t n = outline.points.size(), most = kMostLooks * (n + kFewPoints);
        if (outline.loop_starts.size() != 2 || n < 3) return false;
        looks_left_ = most;
        const bool closed = clip_all(outline, cap);
        cap.steps += most - looks_left_;
        return closed;
    }

private:
    /// Limit of reflex corners looked at, for each point of the loop, before it is given up: teeth that lean over one
    /// another lie in the bounds of many ears.
    static constexpr std::size_t kMostLooks = 256, kFewPoints = 1024;

    bool clip_all(const CapOutline& outline, CapMesh& cap)
    {
        const std::size_t n = outline.points.size();
        points_.assign(outline.points.begin(), outline.points.end());
        ring_.resize(n);
        edge_.resize(n);
        for (Index i = 0; i < n; ++i) {
            ring_[i] = i;
            edge_[i] = CapLink::to_outline(i);
        }
        while (ring_.size() > 3) {
            const std::size_t before = ring_.size();
            clip(cap);
            // Loops that wind like a spiral have few ears at a time; they are left to better triangulators.
            constexpr std::size_t kLeastShare = 64;
            const std::size_t clipped = before - ring_.size();
            if (looks_left_ == 0 || clipped == 0 || clipped * kLeastShare < before) return false;
        }
        // A triangle of no area closes a loop that folds back on itself; it is not worth a special case.
        if (turn(points_[0], points_[1], points_[2]) < 0.0) return false;
        add(cap, 0, 1, 2);
        return true;
    }

    /// One pass. It judges corners as they are at its beginning: clipping an ear makes no corner reflex, and ears that
    /// are not neighbours do not overlap.
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
            last_clipped = free && reflex_[i] == 0 && !reflex_tree_.meets(points_, reflex_, a, i, c, looks_left_);
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

    /// The triangle over corner b; returns its edge from a to c as seen from the rest of the loop.
    CapLink add_ear(CapMesh& cap, std::size_t a, std::size_t b, std::size_t c)
    {
        const Index t = static_cast<Index>(cap.triangles.size());
        cap.triangles.push_back({{ring_[a], ring_[b], ring_[c]}});
        cap.connect(CapLink::to_triangle(t, 0), edge_[a]);
        cap.connect(CapLink::to_triangle(t, 1), edge_[b]);
        return CapLink::to_triangle(t, 2);
    }

    void add(CapMesh& cap, std::size_t a, std::size_t b, std::size_t c)
    {
        const CapLink edge = add_ear(cap, a, b, c);
        cap.connect(edge, edge_[c]);
    }

    std::vector<glm::dvec2> points_;  // of the ring, in its order
    std::vector<Index> ring_;         // their numbers in the outline
    std::vector<CapLink> edge_;       // the edge that leaves each: the outline's, or a triangle's
    std::vector<std::uint8_t> reflex_, clipped_;
    ReflexTree reflex_tree_;
    std::size_t looks_left_ = 0;
};

}  // namespace

std::unique_ptr<CapTriangulator> make_clipping_triangulator()
{
    return std::make_unique<ClippingTriangulator>();
}

}  // namespace kerf::core
