#include "halfedge/universe/triangle_tree.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>

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

Box both(Box a, const Box& b)
{
    a.add(b);
    return a;
}

MassMoments sum(MassMoments a, const MassMoments& b)
{
    a.add(b);
    return a;
}

Support largest(const Support& a, const Support& b)
{
    Support support;
    for (std::size_t i = 0; i < kSupportDirections; i += kLanes)
        store(&support.best[i], larger(load(&b.best[i]), load(&a.best[i])));
    return support;
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
    const Node &l = nodes[left], &r = nodes[right];
    const bool is_one_run = l.group == r.group && l.first + l.count == r.first;
    nodes.push({both(l.box, r.box), left, right, l.first, l.count + r.count, is_one_run ? l.group : GroupId()});
    moments.push(sum(moments[left], moments[right]));
    supports.push(largest(supports[left], supports[right]));
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

bool reaches_beyond(const TriangleTree& tree, const TreeGeometry& geometry, NodeId root, const Plane& plane,
                    double limit, int sign, std::vector<NodeId>& waiting, std::uint64_t& visited)
{
    const auto reach = [&](NodeId n) {
        const auto [lo, hi] = plane.distance_range(tree.nodes[n].box);
        return sign > 0 ? std::array{lo, hi} : std::array{-hi, -lo};
    };
    waiting.clear();
    waiting.push_back(root);
    while (!waiting.empty()) {
        const NodeId n = waiting.back();
        waiting.pop_back();
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
        waiting.push_back(left_first ? node.right : node.left);
        waiting.push_back(left_first ? node.left : node.right);
    }
    return false;
}

}  // namespace kerf::core::halfedge
