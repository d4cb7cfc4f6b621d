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

/// The vertices at the corners of a leaf, in blocks; the last corner is repeated up to a whole block.
class CornerVertices
{
public:
    static constexpr std::size_t kBlock = 8;

    CornerVertices(const TreeGeometry& geometry, const Node& leaf)
        : vertices_(geometry.vertices.data()), index_(geometry.triangle(leaf.first).data())
    {
        static_assert(sizeof(Triangle) == 3 * sizeof(Index));
        const std::size_t corners = std::size_t{3} * leaf.count;
        whole_ = corners / kBlock;
        blocks_ = (corners + kBlock - 1) / kBlock;
        for (std::size_t i = 0; i < kBlock; ++i) rest_[i] = index_[std::min(whole_ * kBlock + i, corners - 1)];
    }

    std::size_t block_count() const { return blocks_; }
    const Index* block(std::size_t b) const { return b < whole_ ? index_ + b * kBlock : rest_.data(); }
    const glm::vec3& position(Index vertex) const { return vertices_[vertex].position; }

private:
    const Vertex* vertices_;
    const Index* index_;
    std::size_t whole_, blocks_;
    std::array<Index, kBlock> rest_;
};

/// The corners of a leaf, coordinate by coordinate.
struct LeafCorners
{
    static constexpr std::size_t kCorners = std::size_t{3} * kMaxLeafTriangles;
    static_assert(kCorners % CornerVertices::kBlock == 0);

    std::size_t count = 0;  ///< whole blocks
    std::array<float, kCorners> x, y, z;

    glm::vec3 operator[](std::size_t corner) const { return {x[corner], y[corner], z[corner]}; }
};

// A position and the first float of the normal are read at once.
static_assert(offsetof(Vertex, position) + sizeof(Four) <= sizeof(Vertex));

void put_four(const CornerVertices& from, const Index* v, std::size_t at, LeafCorners& to)
{
#ifdef __SSE__
    const Four a = load(&from.position(v[0]).x), b = load(&from.position(v[1]).x);
    const Four c = load(&from.position(v[2]).x), d = load(&from.position(v[3]).x);
    const Four ab = _mm_unpacklo_ps(a, b), cd = _mm_unpacklo_ps(c, d);
    store(&to.x[at], _mm_movelh_ps(ab, cd));
    store(&to.y[at], _mm_movehl_ps(cd, ab));
    store(&to.z[at], _mm_movelh_ps(_mm_unpackhi_ps(a, b), _mm_unpackhi_ps(c, d)));
#else
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3& p = from.position(v[i]);
        to.x[at + i] = p.x;
        to.y[at + i] = p.y;
        to.z[at + i] = p.z;
    }
#endif
}

void read_by_four(const CornerVertices& from, LeafCorners& to)
{
    for (std::size_t b = 0; b < from.block_count(); ++b)
        for (std::size_t i = 0; i < CornerVertices::kBlock; i += kLanes, to.count += kLanes)
            put_four(from, from.block(b) + i, to.count, to);
}

#ifdef KERF_AVX2
KERF_AVX2 inline __m256 position_in_each_half(const CornerVertices& from, Index low, Index high)
{
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(&from.position(low).x)),
                                _mm_loadu_ps(&from.position(high).x), 1);
}

KERF_AVX2 inline void read_by_eight(const CornerVertices& from, LeafCorners& to)
{
    constexpr int kFronts = 0x44, kBacks = 0xEE;  // of each half: two numbers of one and two of the other
    for (std::size_t block = 0; block < from.block_count(); ++block, to.count += CornerVertices::kBlock) {
        const Index* const v = from.block(block);
        const __m256 a = position_in_each_half(from, v[0], v[4]), b = position_in_each_half(from, v[1], v[5]);
        const __m256 c = position_in_each_half(from, v[2], v[6]), d = position_in_each_half(from, v[3], v[7]);
        const __m256 ab = _mm256_unpacklo_ps(a, b), cd = _mm256_unpacklo_ps(c, d);
        _mm256_storeu_ps(&to.x[to.count], _mm256_shuffle_ps(ab, cd, kFronts));
        _mm256_storeu_ps(&to.y[to.count], _mm256_shuffle_ps(ab, cd, kBacks));
        _mm256_storeu_ps(&to.z[to.count],
                         _mm256_shuffle_ps(_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d), kFronts));
    }
}
#endif

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
KERF_AVX2 inline CornerBits extreme_by_eight(const LeafCorners& corners, const glm::vec3& d, float value)
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
#ifdef KERF_AVX2
        if (has_avx2()) return search_by_eight(leaf, directions);
#endif
        search_by_four(leaf, directions);
    }

    void search_by_four(const Node& leaf, Directions directions)
    {
        LeafCorners corners;
        read_by_four(CornerVertices(geometry_, leaf), corners);
        for (; directions != 0; directions &= directions - 1) {
            const auto d = std::size_t(std::countr_zero(directions));
            propose(d, corners, extreme_by_four(corners, wanted_[d], best_.best[d]));
        }
    }

#ifdef KERF_AVX2
    KERF_AVX2 void search_by_eight(const Node& leaf, Directions directions)
    {
        LeafCorners corners;
        read_by_eight(CornerVertices(geometry_, leaf), corners);
        for (; directions != 0; directions &= directions - 1) {
            const auto d = std::size_t(std::countr_zero(directions));
            propose(d, corners, extreme_by_eight(corners, wanted_[d], best_.best[d]));
        }
    }
#endif

    KERF_IN_CALLER void propose(std::size_t d, const LeafCorners& corners, const CornerBits& is_extreme)
    {
        for (std::size_t word = 0; word < is_extreme.size(); ++word)
            for (std::uint64_t bits = is_extreme[word]; bits != 0; bits &= bits - 1)
                propose(d, corners[64 * word + std::size_t(std::countr_zero(bits))]);
    }

    void propose(std::size_t d, const glm::vec3& p)
    {
        if ((found_ >> d & 1) == 0 || lexicographically_less(p, points_[d])) points_[d] = p;
        found_ |= Directions(1) << d;
    }

    const TriangleTree& tree_;
    const TreeGeometry& geometry_;
    const std::array<glm::vec3, kSupportDirections>& wanted_ = support_directions();
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
