#include "halfedge/universe/support_search.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/cutting/cut_geometry.h"
#include "common/mesh/four_floats.h"
#include "common/support/processor.h"

#ifdef KERF_AVX2
#include <immintrin.h>
#endif

namespace kerf::core::halfedge {

namespace {

/// Directions of search, one bit each.
using Directions = std::uint32_t;
static_assert(kSupportDirections <= 32);

/// The corners of a leaf, coordinate by coordinate, the last one repeated up to a whole number of blocks.
struct LeafCorners
{
    static constexpr std::size_t kBlock = 8;
    static constexpr std::size_t kCorners = std::size_t{3} * kMaxLeafTriangles;
    static_assert(kCorners % kBlock == 0);

    LeafCorners(const TreeGeometry& geometry, const Node& leaf)
    {
        assert(leaf.count <= kMaxLeafTriangles);
        static_assert(sizeof(Triangle) == 3 * sizeof(Index));
        const Index* const index = geometry.triangle(leaf.first).data();
        const std::size_t corners = std::size_t{3} * leaf.count;
        const auto vertex = [&](std::size_t corner) { return &geometry.vertices[index[corner]]; };
        for (; count + kLanes <= corners; count += kLanes)
            put_four(count, {vertex(count), vertex(count + 1), vertex(count + 2), vertex(count + 3)});
        for (const Vertex* const last = vertex(corners - 1); count < corners || count % kBlock != 0; count += kLanes) {
            const auto or_last = [&](std::size_t corner) { return corner < corners ? vertex(corner) : last; };
            put_four(count, {or_last(count), or_last(count + 1), or_last(count + 2), or_last(count + 3)});
        }
    }

    glm::vec3 operator[](std::size_t corner) const { return {x[corner], y[corner], z[corner]}; }

    std::size_t count = 0;
    std::array<float, kCorners> x, y, z;

private:
    void put_four(std::size_t corner, const std::array<const Vertex*, kLanes>& v)
    {
#ifdef __SSE__
        // A position and the first float of the normal in one load.
        static_assert(offsetof(Vertex, position) + sizeof(Four) <= sizeof(Vertex));
        const Four a = load(&v[0]->position.x), b = load(&v[1]->position.x);
        const Four c = load(&v[2]->position.x), d = load(&v[3]->position.x);
        const Four ab = _mm_unpacklo_ps(a, b), cd = _mm_unpacklo_ps(c, d);
        store(&x[corner], _mm_movelh_ps(ab, cd));
        store(&y[corner], _mm_movehl_ps(cd, ab));
        store(&z[corner], _mm_movelh_ps(_mm_unpackhi_ps(a, b), _mm_unpackhi_ps(c, d)));
#else
        for (std::size_t i = 0; i < kLanes; ++i) {
            x[corner + i] = v[i]->position.x;
            y[corner + i] = v[i]->position.y;
            z[corner + i] = v[i]->position.z;
        }
#endif
    }
};

/// One bit for each corner of a leaf.
using CornerBits = std::array<std::uint64_t, (LeafCorners::kCorners + 63) / 64>;

/// Which corners have the support value `value` along a direction. The order of operations is that of support_value().
CornerBits extreme_by_four(const LeafCorners& corners, const glm::vec3& d, float value)
{
    CornerBits bits{};
    for (std::size_t i = 0; i < corners.count; i += kLanes) {
        const Four values = (d.x * load(&corners.x[i]) + d.y * load(&corners.y[i])) + d.z * load(&corners.z[i]);
        bits[i / 64] |= std::uint64_t{equal_lanes(values, Four{} + value)} << i % 64;
    }
    return bits;
}

#ifdef KERF_AVX2
/// The same.
KERF_AVX2 CornerBits extreme_by_eight(const LeafCorners& corners, const glm::vec3& d, float value)
{
    const __m256 dx = _mm256_set1_ps(d.x), dy = _mm256_set1_ps(d.y), dz = _mm256_set1_ps(d.z);
    const __m256 wanted = _mm256_set1_ps(value);
    CornerBits bits{};
    for (std::size_t i = 0; i < corners.count; i += 8) {
        const __m256 x = _mm256_loadu_ps(&corners.x[i]), y = _mm256_loadu_ps(&corners.y[i]);
        const __m256 values = (dx * x + dy * y) + dz * _mm256_loadu_ps(&corners.z[i]);
        const int lanes = _mm256_movemask_ps(_mm256_cmp_ps(values, wanted, _CMP_EQ_OQ));
        bits[i / 64] |= std::uint64_t{static_cast<std::uint8_t>(lanes)} << i % 64;
    }
    return bits;
}
#endif

CornerBits extreme_corners(const LeafCorners& corners, const glm::vec3& d, float value)
{
#ifdef KERF_AVX2
    if (has_avx2()) return extreme_by_eight(corners, d, value);
#endif
    return extreme_by_four(corners, d, value);
}

/// One walk over the tree for the extreme vertices along all directions: most leaves that hold one hold several.
///
/// Far from the caches it goes down level by level, so that the nodes of a level are waited for together. A level gets
/// large only if many vertices share a maximum (a flat side). From there on the walk goes node by node, least corner
/// first: what it finds rules most of the others out.
class SupportSearch
{
public:
    SupportSearch(const TriangleTree& tree, const TreeGeometry& geometry, std::span<const NodeId> roots)
        : tree_(tree), geometry_(geometry)
    {
        for (const NodeId root : roots) best_.add(tree.supports[root]);
        points_.fill(glm::vec3(0.0f));
        constexpr std::size_t kUsualDepth = 64;
        stack_.reserve(roots.size() + kUsualDepth);
        for (auto root = roots.rbegin(); root != roots.rend(); ++root) visit_later(*root, ~Directions(0));
        if (geometry.is_far_away()) go_down_together();
        while (!stack_.empty()) {
            const Step step = stack_.back();
            stack_.pop_back();
            visit(step.node, step.directions);
        }
    }

    const std::array<glm::vec3, kSupportDirections>& points() const { return points_; }

private:
    /// A subtree to be looked at, for some of the directions.
    struct Step
    {
        NodeId node;
        Directions directions;
    };

    /// From the nodes of the stack down to the leaves, or until a level is large; they are the stack then.
    void go_down_together()
    {
        constexpr std::size_t kTogether = 2 * kSupportDirections;
        std::vector<Step> level, below;
        level.swap(stack_);
        while (!level.empty() && level.size() <= kTogether) {
            below.clear();
            for (const Step& step : level) {
                const Node& node = tree_.nodes[step.node];
                if (node.is_leaf()) {
                    stack_.push_back(step);
                    for (std::uint32_t i = 0; i < node.count; ++i)
                        __builtin_prefetch(&geometry_.triangle(node.first + i));
                    continue;
                }
                for (const NodeId child : {node.left, node.right}) {
                    tree_.prefetch_support(child);
                    below.push_back({child, step.directions});
                }
            }
            level.clear();
            for (const Step& step : below)
                if (const Directions reached = step.directions & reached_by(step.node); reached != 0)
                    level.push_back({step.node, reached});
        }
        for (const Step& step : stack_) {
            const Node& leaf = tree_.nodes[step.node];
            for (std::uint32_t i = 0; i < leaf.count; ++i)
                for (const Index v : geometry_.triangle(leaf.first + i)) __builtin_prefetch(&geometry_.vertices[v]);
        }
        if (level.empty()) return;
        stack_.insert(stack_.end(), level.begin(), level.end());
        std::sort(stack_.begin(), stack_.end(), [&](const Step& a, const Step& b) {
            return lexicographically_less(tree_.nodes[b.node].box.lo, tree_.nodes[a.node].box.lo);
        });
    }

    void visit_later(NodeId n, Directions directions)
    {
        if ((directions &= reached_by(n)) != 0) stack_.push_back({n, directions});
    }

    /// Along which directions a subtree reaches as far as any.
    Directions reached_by(NodeId n) const
    {
        const Support& support = tree_.supports[n];
        Directions reached = 0;
        for (std::size_t d = 0; d < kSupportDirections; d += kLanes)
            reached |= Directions{equal_lanes(load(&support.best[d]), load(&best_.best[d]))} << d;
        return reached;
    }

    void visit(NodeId n, Directions directions)
    {
        const Node& node = tree_.nodes[n];
        // Several vertices may share the maximum (all of a flat side): a box whose least corner does not come before
        // the point found holds nothing better.
        for (Directions found = directions & found_; found != 0; found &= found - 1) {
            const int d = std::countr_zero(found);
            if (!lexicographically_less(node.box.lo, points_[std::size_t(d)])) directions &= ~(Directions(1) << d);
        }
        if (directions == 0) return;
        if (node.is_leaf()) {
            search(node, directions);
            return;
        }
        const bool left_first = lexicographically_less(tree_.nodes[node.left].box.lo, tree_.nodes[node.right].box.lo);
        visit_later(left_first ? node.right : node.left, directions);
        visit_later(left_first ? node.left : node.right, directions);
    }

    void search(const Node& leaf, Directions directions)
    {
        const LeafCorners corners(geometry_, leaf);
        for (; directions != 0; directions &= directions - 1) {
            const auto d = std::size_t(std::countr_zero(directions));
            const CornerBits is_extreme = extreme_corners(corners, support_directions()[d], best_.best[d]);
            for (std::size_t word = 0; word < is_extreme.size(); ++word)
                for (std::uint64_t bits = is_extreme[word]; bits != 0; bits &= bits - 1)
                    propose(d, corners[64 * word + std::size_t(std::countr_zero(bits))]);
        }
    }

    void propose(std::size_t d, const glm::vec3& p)
    {
        if ((found_ >> d & 1) == 0 || lexicographically_less(p, points_[d])) points_[d] = p;
        found_ |= Directions(1) << d;
    }

    const TriangleTree& tree_;
    const TreeGeometry& geometry_;
    Support best_ = Support::none();
    Directions found_ = 0;  ///< those that a point was found for
    std::array<glm::vec3, kSupportDirections> points_;
    std::vector<Step> stack_;
};

}  // namespace

std::array<glm::vec3, kSupportDirections> support_points(const TriangleTree& tree, const TreeGeometry& geometry,
                                                         std::span<const NodeId> roots)
{
    return SupportSearch(tree, geometry, roots).points();
}

}  // namespace kerf::core::halfedge
