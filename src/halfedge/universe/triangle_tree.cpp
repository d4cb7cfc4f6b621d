#include "halfedge/universe/triangle_tree.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <limits>
#include <utility>

#include "common/cutting/cut_geometry.h"
#include "common/mesh/four_floats.h"
#include "common/mesh/mass_moments.h"
#include "common/support/processor.h"

#ifdef KERF_AVX2
#include <immintrin.h>
#endif

namespace kerf::core::halfedge {

namespace {

constexpr std::size_t kLines = kSupportDirections / 2;  // directions come in opposite pairs, i and i + kLines
constexpr std::size_t kUsualDepth = 64;                 // what a stack has room for

/// One of each pair of directions, four at a time.
struct Lines
{
    std::array<Four, kLines / kLanes> x, y, z;
};

const Lines& lines()
{
    static const Lines table = [] {
        Lines l;
        for (std::size_t i = 0; i < kLines; ++i) {
            const glm::vec3& d = support_directions()[i];
            assert(support_directions()[i + kLines] == -d);
            l.x[i / kLanes][i % kLanes] = d.x;
            l.y[i / kLanes][i % kLanes] = d.y;
            l.z[i / kLanes][i % kLanes] = d.z;
        }
        return l;
    }();
    return table;
}

/// Maxima over vertices, in registers.
class SupportSum
{
public:
    SupportSum()
    {
        for (std::size_t i = 0; i < kLines / kLanes; ++i) {
            high_[i] = Four{} - std::numeric_limits<float>::infinity();
            low_[i] = Four{} + std::numeric_limits<float>::infinity();
        }
    }

    void add(const Lines& l, const glm::vec3& p)
    {
        for (std::size_t i = 0; i < kLines / kLanes; ++i) {
            // The order of operations is that of support_value().
            const Four value = (l.x[i] * p.x + l.y[i] * p.y) + l.z[i] * p.z;
            high_[i] = larger(value, high_[i]);
            low_[i] = smaller(value, low_[i]);
        }
    }

    Support support() const
    {
        Support support;
        for (std::size_t i = 0; i < kLines / kLanes; ++i) {
            store(&support.best[i * kLanes], high_[i]);
            // Rounding is symmetric, so the value along -d is the negative of the value along d.
            store(&support.best[kLines + i * kLanes], -low_[i]);
        }
        return support;
    }

private:
    std::array<Four, kLines / kLanes> high_, low_;
};

/// Remembers which vertices of a leaf were seen. It may forget, which costs time only.
class SeenVertices
{
public:
    bool is_new(Index vertex)
    {
        Index& entry = table_[vertex % kEntries];
        if (entry == vertex) return false;
        entry = vertex;
        return true;
    }
    void clear() { table_.fill(kNone); }

private:
    static constexpr std::size_t kEntries = 128;
    std::array<Index, kEntries> table_;
};

Support find_maxima_by_four(const TreeGeometry& geometry, SlotId first, std::uint32_t count)
{
    const Lines& l = lines();
    SupportSum sum;
    SeenVertices seen;
    seen.clear();
    for (SlotId s = first; s < first + count; ++s)
        for (const Index v : geometry.triangle(s))
            if (seen.is_new(v)) sum.add(l, geometry.vertices[v].position);
    return sum.support();
}

#ifdef KERF_AVX2
/// The same. Eight at a time, looking at a vertex again costs less than a branch on whether it was seen.
KERF_AVX2 Support find_maxima_by_eight(const TreeGeometry& geometry, SlotId first, std::uint32_t count)
{
    static_assert(kLines == 16);
    const float* const x = reinterpret_cast<const float*>(lines().x.data());
    const float* const y = reinterpret_cast<const float*>(lines().y.data());
    const float* const z = reinterpret_cast<const float*>(lines().z.data());
    const __m256 x0 = _mm256_loadu_ps(x), x1 = _mm256_loadu_ps(x + 8);
    const __m256 y0 = _mm256_loadu_ps(y), y1 = _mm256_loadu_ps(y + 8);
    const __m256 z0 = _mm256_loadu_ps(z), z1 = _mm256_loadu_ps(z + 8);
    const __m256 infinity = _mm256_set1_ps(std::numeric_limits<float>::infinity());
    __m256 low0 = infinity, low1 = infinity, high0 = -infinity, high1 = -infinity;
    for (SlotId s = first; s < first + count; ++s)
        for (const Index v : geometry.triangle(s)) {
            const glm::vec3& p = geometry.vertices[v].position;
            const __m256 px = _mm256_broadcast_ss(&p.x), py = _mm256_broadcast_ss(&p.y), pz = _mm256_broadcast_ss(&p.z);
            // The order of operations is that of support_value().
            const __m256 value0 = (x0 * px + y0 * py) + z0 * pz, value1 = (x1 * px + y1 * py) + z1 * pz;
            high0 = _mm256_max_ps(value0, high0);
            high1 = _mm256_max_ps(value1, high1);
            low0 = _mm256_min_ps(value0, low0);
            low1 = _mm256_min_ps(value1, low1);
        }
    Support support;
    _mm256_storeu_ps(&support.best[0], high0);
    _mm256_storeu_ps(&support.best[8], high1);
    // Rounding is symmetric, so the value along -d is the negative of the value along d.
    _mm256_storeu_ps(&support.best[kLines], -low0);
    _mm256_storeu_ps(&support.best[kLines + 8], -low1);
    return support;
}
#endif

Support find_maxima(const TreeGeometry& geometry, SlotId first, std::uint32_t count)
{
#ifdef KERF_AVX2
    if (has_avx2()) return find_maxima_by_eight(geometry, first, count);
#endif
    return find_maxima_by_four(geometry, first, count);
}

}  // namespace

Support Support::none()
{
    Support support;
    support.best.fill(-std::numeric_limits<float>::infinity());
    return support;
}

void Support::add(const glm::vec3& p)
{
    for (std::size_t d = 0; d < kSupportDirections; ++d)
        best[d] = std::max(best[d], support_value(support_directions()[d], p));
}

void Support::add(const Support& other)
{
    for (std::size_t i = 0; i < kSupportDirections; i += kLanes)
        store(&best[i], larger(load(&other.best[i]), load(&best[i])));
}

Box Support::box() const
{
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        box.hi[axis] = best[i] + 0.0f;  // not -0
        box.lo[axis] = 0.0f - best[kLines + i];
    }
    return box;
}

NodeId TriangleTree::make_leaf(const TreeGeometry& geometry, SlotId first, std::uint32_t count, GroupId group)
{
    const Support support = find_maxima(geometry, first, count);
    nodes.push({support.box(), NodeId(), NodeId(), first, count, group});
    moments.push(
        geometry.moments_wanted
            ? mass_moments(geometry.vertices, geometry.slots.subspan(first.number(), count), geometry.reference)
            : MassMoments::unknown());
    supports.push(support);
    return last();
}

NodeId TriangleTree::join(NodeId left, NodeId right)
{
    if (!left.is_valid()) return right;
    if (!right.is_valid()) return left;
    Node node;
    const Node &l = nodes[left], &r = nodes[right];
    node.box = l.box;
    node.box.add(r.box);
    node.left = left;
    node.right = right;
    node.count = l.count + r.count;
    node.first = l.first;
    node.group = l.group == r.group && l.first + l.count == r.first ? l.group : GroupId();
    nodes.push(node);
    moments.push(moments[left]);
    moments[last()].add(moments[right]);
    supports.push(supports[left]);
    supports[last()].add(supports[right]);
    return last();
}

NodeId TriangleTree::merge_leaves(NodeId left, NodeId right)
{
    nodes[left].box.add(nodes[right].box);
    nodes[left].count += nodes[right].count;
    moments[left].add(moments[right]);
    supports[left].add(supports[right]);
    return left;
}

void TriangleTree::reserve(std::size_t count, std::size_t written_soon)
{
    nodes.reserve(count, written_soon);
    moments.reserve(count, written_soon);
    supports.reserve(count, written_soon);
}

std::size_t TriangleTree::make_room(std::size_t count)
{
    return nodes.make_room(count) + moments.make_room(count) + supports.make_room(count);
}

std::size_t TriangleTree::bytes_reserved() const
{
    return nodes.bytes_reserved() + moments.bytes_reserved() + supports.bytes_reserved();
}

void TriangleTree::append_runs(NodeId root, std::vector<Run>& runs) const
{
    std::vector<NodeId> stack;
    stack.reserve(kUsualDepth);
    if (runs.empty()) runs.reserve(kUsualDepth);
    if (root.is_valid()) stack.push_back(root);
    while (!stack.empty()) {
        const Node& node = nodes[stack.back()];
        stack.pop_back();
        if (node.is_mixed()) {
            stack.push_back(node.right);
            stack.push_back(node.left);
        } else if (!runs.empty() && runs.back().group == node.group &&
                   runs.back().first + runs.back().count == node.first) {
            runs.back().count += node.count;
        } else {
            runs.push_back({node.first, node.count, node.group});
        }
    }
}

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
class SupportSearch
{
public:
    SupportSearch(const TriangleTree& tree, const TreeGeometry& geometry, std::span<const NodeId> roots)
        : tree_(tree), geometry_(geometry)
    {
        for (const NodeId root : roots) best_.add(tree.supports[root]);
        points_.fill(glm::vec3(0.0f));
        stack_.reserve(roots.size() + kUsualDepth);
        for (auto root = roots.rbegin(); root != roots.rend(); ++root) visit_later(*root, ~Directions(0));
        while (!stack_.empty()) {
            const auto [node, directions] = stack_.back();
            stack_.pop_back();
            visit(node, directions);
        }
    }

    const std::array<glm::vec3, kSupportDirections>& points() const { return points_; }

private:
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
    std::vector<std::pair<NodeId, Directions>> stack_;
};

}  // namespace

bool reaches_beyond(const TriangleTree& tree, const TreeGeometry& geometry, NodeId root, const Plane& plane,
                    double limit, int sign, std::uint64_t& visited)
{
    const auto reach = [&](NodeId n) {
        const auto [lo, hi] = plane.distance_range(tree.nodes[n].box);
        return sign > 0 ? std::array{lo, hi} : std::array{-hi, -lo};
    };
    std::vector<NodeId> stack;
    stack.reserve(kUsualDepth);
    stack.push_back(root);
    while (!stack.empty()) {
        const NodeId n = stack.back();
        stack.pop_back();
        ++visited;
        const auto [near, far] = reach(n);
        if (!(far > limit)) continue;
        if (near > limit) return true;
        const Node& node = tree.nodes[n];
        if (node.is_leaf()) {
            for (SlotId s = node.first; s < node.first + node.count; ++s)
                for (const std::uint32_t v : geometry.triangle(s))
                    if (sign * plane.signed_distance(geometry.vertices[v].position) > limit) return true;
            continue;
        }
        const bool left_first = reach(node.left)[1] > reach(node.right)[1];
        stack.push_back(left_first ? node.right : node.left);
        stack.push_back(left_first ? node.left : node.right);
    }
    return false;
}

std::array<glm::vec3, kSupportDirections> support_points(const TriangleTree& tree, const TreeGeometry& geometry,
                                                         std::span<const NodeId> roots)
{
    return SupportSearch(tree, geometry, roots).points();
}

}  // namespace kerf::core::halfedge
