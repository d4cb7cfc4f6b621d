#include "common/caps/patient_triangulator.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/caps/hole_bridges.h"
#include "common/caps/loop_boxes.h"
#include "common/caps/morton.h"
#include "common/geometry/turn.h"

// Clipping an ear changes what its two neighbours are, and no other corner (O'Rourke 1998, "Computational Geometry in C",
// section 1.6.5): corners wait in a queue, and come back to it if a neighbour was clipped. So ears are clipped in turn
// around the ring, which keeps triangles short, and a corner is judged some three times in all. If loops do not cross, a
// corner never becomes reflex, so the tree of reflex corners is built once.
//
// Triangles that all run counter-clockwise cover a place as often as the outline winds around it, since their edges are
// those of the outline: a corner that is taken for an ear and is none can stop the clipping, and do no other harm.

namespace kerf::core {

namespace {

class PatientTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        cap.clear();
        if (outline.points.size() < 3) return false;
        looks_left_ = kMostLooks;
        const bool closed = bridge_holes(outline, rings_, looks_left_) && clip_all(outline, cap);
        cap.steps += kMostLooks - looks_left_;
        return closed;
    }

private:
    /// Corners that may be looked at: some seconds.
    static constexpr std::uint64_t kMostLooks = std::uint64_t{1} << 27;

    bool clip_all(const CapOutline& outline, CapMesh& cap)
    {
        for (std::size_t ring = 0; ring + 1 < rings_.starts.size(); ++ring) {
            start(outline, rings_.starts[ring], rings_.starts[ring + 1]);
            if (!clip_ring(cap)) return false;
        }
        join_bridges(outline, cap);
        cap.shared_points = rings_.shared;
        return true;
    }

    void start(const CapOutline& outline, Index first, Index last)
    {
        const Index n = last - first;
        points_.resize(n);
        before_.resize(n);
        after_.resize(n);
        for (Index i = 0; i < n; ++i) {
            points_[i] = outline.points[rings_.points[first + i]];
            before_[i] = i == 0 ? n - 1 : i - 1;
            after_[i] = i + 1 == n ? 0 : i + 1;
        }
        number_ = {rings_.points.data() + first, n};
        edge_.assign(rings_.links.begin() + first, rings_.links.begin() + last);
        reflex_.resize(n);
        for (Index i = 0; i < n; ++i) reflex_[i] = is_reflex(i);
        sort_reflex_corners();
        boxes_.build(order_.size(),
                     [&](std::size_t i, Box2& box) { box.add(points_[order_[i]].x, points_[order_[i]].y); });
        is_waiting_.assign(n, 0);
    }

    /// Along a Morton curve of 65536 x 65536 cells: a ring of many bridges runs to and fro, and is no good tree.
    void sort_reflex_corners()
    {
        Box2 box;
        for (const glm::dvec2& p : points_) box.add(p.x, p.y);
        const glm::dvec2 lo(box.lo_x, box.lo_y);
        const double longest = std::max(box.hi_x - box.lo_x, box.hi_y - box.lo_y);
        const double scale = longest > 0.0 ? 65535.0 / longest : 0.0;
        keys_.clear();
        for (Index i = 0; i < points_.size(); ++i)
            if (reflex_[i] != 0) {
                const glm::dvec2 cell = (points_[i] - lo) * scale;
                keys_.emplace_back(morton(std::uint32_t(cell.x), std::uint32_t(cell.y)), i);
            }
        std::sort(keys_.begin(), keys_.end());
        order_.clear();
        for (const auto& [key, i] : keys_) order_.push_back(i);
    }

    bool clip_ring(CapMesh& cap)
    {
        std::size_t left = points_.size(), left_before = left + 1;
        if (left < 3) return false;
        while (left > 3) {
            // The second time only where points lie in diagonals: an ear may have appeared beside none that was clipped.
            if (left == left_before) return false;
            left_before = left;
            queue_.clear();
            for (Index i = 0; i < points_.size(); ++i)
                if (is_left(i)) wait(i);
            for (std::size_t next = 0; next < queue_.size() && left > 3; ++next) {
                const Index b = queue_[next];
                is_waiting_[b] = 0;
                if (!is_left(b) || is_reflex(b) || !is_ear(b)) continue;
                clip(b, cap);
                --left;
            }
            if (looks_left_ == 0) return false;
        }
        Index a = 0;
        while (!is_left(a)) ++a;
        const Index b = after_[a], c = before_[a];
        // A triangle of no area closes a loop that folds back on itself, but needs three places.
        const glm::dvec2 &pa = points_[a], &pb = points_[b], &pc = points_[c];
        if (turn(pa, pb, pc) < 0.0 || pa == pb || pb == pc || pc == pa) return false;
        cap.connect(add(a, b, c, cap), edge_[c]);
        return true;
    }

    /// Joins the triangles on both sides of each bridge.
    void join_bridges(const CapOutline& outline, CapMesh& cap)
    {
        if (rings_.bridge_count == 0) return;
        const Index n = static_cast<Index>(outline.points.size());
        bridge_sides_.resize(2 * rings_.bridge_count);
        for (Index t = 0; t < cap.triangles.size(); ++t)
            for (Index i = 0; i < 3; ++i)
                if (const CapLink link = cap.triangles[t].link[i]; link.is_outline() && link.outline_edge() >= n)
                    bridge_sides_[link.outline_edge() - n] = CapLink::to_triangle(t, i);
        for (std::size_t bridge = 0; bridge < rings_.bridge_count; ++bridge)
            cap.connect(bridge_sides_[2 * bridge], bridge_sides_[2 * bridge + 1]);
    }

    /// Whether a corner is still on the ring.
    bool is_left(Index i) const { return after_[i] != i; }

    bool is_reflex(Index b) const { return turn(points_[before_[b]], points_[b], points_[after_[b]]) <= 0.0; }

    /// Whether no other reflex corner lies in or on the triangle over b. Those that share a place with one of its corners
    /// don't count: bridges make them, and loops that touch.
    bool is_ear(Index b)
    {
        const Index ia = before_[b], ic = after_[b];
        const glm::dvec2 &pa = points_[ia], &pb = points_[b], &pc = points_[ic];
        Box2 box;
        for (const glm::dvec2* p : {&pa, &pb, &pc}) box.add(p->x, p->y);
        return !boxes_.any(box, [&](std::size_t place) {
            if (looks_left_ == 0) return true;
            const Index i = order_[place];
            --looks_left_;
            const glm::dvec2& p = points_[i];
            if (reflex_[i] == 0 || p == pa || p == pb || p == pc) return false;
            return turn(pa, pb, p) >= 0.0 && turn(pb, pc, p) >= 0.0 && turn(pc, pa, p) >= 0.0;
        });
    }

    void clip(Index b, CapMesh& cap)
    {
        const Index a = before_[b], c = after_[b];
        edge_[a] = add(a, b, c, cap);
        after_[a] = c;
        before_[c] = a;
        after_[b] = b;
        for (const Index i : {a, c}) {
            reflex_[i] = is_reflex(i);
            wait(i);
        }
    }

    /// The triangle over corner b; returns its edge from c to a.
    CapLink add(Index a, Index b, Index c, CapMesh& cap)
    {
        const Index t = static_cast<Index>(cap.triangles.size());
        cap.triangles.push_back({{number_[a], number_[b], number_[c]}});
        cap.connect(CapLink::to_triangle(t, 0), edge_[a]);
        cap.connect(CapLink::to_triangle(t, 1), edge_[b]);
        return CapLink::to_triangle(t, 2);
    }

    void wait(Index i)
    {
        if (is_waiting_[i] != 0) return;
        is_waiting_[i] = 1;
        queue_.push_back(i);
    }

    Rings rings_;
    std::vector<CapLink> bridge_sides_;
    // Of the ring that is clipped:
    std::vector<glm::dvec2> points_;
    std::span<const Index> number_;      // in the outline
    std::vector<Index> before_, after_;  // of each corner that is left
    std::vector<CapLink> edge_;          // the edge that leaves each: the outline's, or a triangle's
    std::vector<std::uint8_t> reflex_, is_waiting_;
    std::vector<Index> queue_;
    std::vector<std::pair<std::uint32_t, Index>> keys_;
    std::vector<Index> order_;  // of the reflex corners
    LoopBoxes boxes_;
    std::uint64_t looks_left_ = 0;
};

}  // namespace

std::unique_ptr<CapTriangulator> make_patient_triangulator()
{
    return std::make_unique<PatientTriangulator>();
}

}  // namespace kerf::core
