#include "halfedge/triangle_tree.h"

#include <limits>

#include "common/cut_geometry.h"

namespace kerf::halfedge {

namespace {

/// The directions as structure of arrays, so that one vertex meets four of them at a time.
struct Directions
{
    alignas(16) std::array<float, kSupportDirections> x, y, z;
};

const Directions& directions()
{
    static const Directions table = [] {
        Directions d;
        for (std::size_t i = 0; i < kSupportDirections; ++i) {
            d.x[i] = support_directions()[i].x;
            d.y[i] = support_directions()[i].y;
            d.z[i] = support_directions()[i].z;
        }
        return d;
    }();
    return table;
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
    // The order of operations is that of support_value().
    const Directions& d = directions();
    for (std::size_t i = 0; i < kSupportDirections; ++i) {
        const float value = (d.x[i] * p.x + d.y[i] * p.y) + d.z[i] * p.z;
        best[i] = value > best[i] ? value : best[i];
    }
}

void Support::add(const Support& other)
{
    for (std::size_t i = 0; i < kSupportDirections; ++i) best[i] = other.best[i] > best[i] ? other.best[i] : best[i];
}

void Summary::add(const TreeGeometry& geometry, const Triangle& triangle)
{
    const glm::vec3& a = geometry.vertices[triangle[0]].position;
    const glm::vec3& b = geometry.vertices[triangle[1]].position;
    const glm::vec3& c = geometry.vertices[triangle[2]].position;
    moments.add(geometry.reference, a, b, c);
    for (const glm::vec3* p : {&a, &b, &c}) {
        box.add(*p);
        support.add(*p);
    }
}

Index TriangleTree::make_leaf(const TreeGeometry& geometry, std::uint32_t first, std::uint32_t count, Index group)
{
    Summary sum;
    for (std::uint32_t s = first; s < first + count; ++s) sum.add(geometry, geometry.slots[s]);
    nodes.push({sum.box, kNone, kNone, first, count, group});
    moments.push(sum.moments);
    supports.push(sum.support);
    return static_cast<Index>(nodes.size() - 1);
}

Index TriangleTree::make_run(const TreeGeometry& geometry, std::uint32_t first, std::uint32_t count, Index group)
{
    if (count == 0) return kNone;
    if (count <= kLeafTriangles) return make_leaf(geometry, first, count, group);
    // Halve the number of leaves, so that all but the last are full.
    const std::uint32_t leaves = (count + kLeafTriangles - 1) / kLeafTriangles;
    const std::uint32_t half = (leaves / 2) * kLeafTriangles;
    const Index left = make_run(geometry, first, half, group);
    const Index right = make_run(geometry, first + half, count - half, group);
    return join(left, right);
}

Index TriangleTree::join(Index left, Index right)
{
    if (left == kNone) return right;
    if (right == kNone) return left;
    Node node;
    const Node &l = nodes[left], &r = nodes[right];
    node.box = l.box;
    node.box.add(r.box);
    node.left = left;
    node.right = right;
    node.count = l.count + r.count;
    node.first = l.first;
    node.group = l.group == r.group && l.first + l.count == r.first ? l.group : kMixed;
    MassMoments moment = moments[left];
    moment.add(moments[right]);
    Support support = supports[left];
    support.add(supports[right]);
    nodes.push(node);
    moments.push(moment);
    supports.push(support);
    return static_cast<Index>(nodes.size() - 1);
}

Index TriangleTree::merge_leaves(Index left, Index right)
{
    nodes[left].box.add(nodes[right].box);
    nodes[left].count += nodes[right].count;
    moments[left].add(moments[right]);
    supports[left].add(supports[right]);
    return left;
}

void TriangleTree::reserve(std::size_t count)
{
    nodes.reserve(count);
    moments.reserve(count);
    supports.reserve(count);
}

std::size_t TriangleTree::make_room(std::size_t count)
{
    return nodes.make_room(count) + moments.make_room(count) + supports.make_room(count);
}

std::size_t TriangleTree::bytes_reserved() const
{
    return nodes.bytes_reserved() + moments.bytes_reserved() + supports.bytes_reserved();
}

void TriangleTree::append_runs(Index root, std::vector<Run>& runs) const
{
    std::vector<Index> stack;
    if (root != kNone) stack.push_back(root);
    while (!stack.empty()) {
        const Node& node = nodes[stack.back()];
        stack.pop_back();
        if (node.group == kMixed) {
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

bool reaches_beyond(const TriangleTree& tree, const TreeGeometry& geometry, Index root, const Plane& plane,
                    double limit, int sign)
{
    const auto reach = [&](Index n) {
        const auto [lo, hi] = plane.distance_range(tree.nodes[n].box);
        return sign > 0 ? std::array{lo, hi} : std::array{-hi, -lo};
    };
    std::vector<Index> stack{root};
    while (!stack.empty()) {
        const Index n = stack.back();
        stack.pop_back();
        const auto [near, far] = reach(n);
        if (!(far > limit)) continue;
        if (near > limit) return true;
        const Node& node = tree.nodes[n];
        if (node.is_leaf()) {
            for (std::uint32_t s = node.first; s < node.first + node.count; ++s)
                for (const std::uint32_t v : geometry.slots[s])
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
                                                         std::span<const Index> roots)
{
    Support best = Support::none();
    for (const Index root : roots) best.add(tree.supports[root]);

    std::array<glm::vec3, kSupportDirections> points;
    std::vector<Index> stack;
    for (std::size_t d = 0; d < kSupportDirections; ++d) {
        const glm::vec3& direction = support_directions()[d];
        bool found = false;
        glm::vec3 point{0.0f};
        // Several vertices may share the maximum (all of a flat side): a box whose least corner does not come before
        // the point found holds nothing better.
        stack.assign(roots.rbegin(), roots.rend());
        while (!stack.empty()) {
            const Index n = stack.back();
            stack.pop_back();
            if (tree.supports[n].best[d] != best.best[d]) continue;
            const Node& node = tree.nodes[n];
            if (found && !lexicographically_less(node.box.lo, point)) continue;
            if (node.is_leaf()) {
                for (std::uint32_t s = node.first; s < node.first + node.count; ++s)
                    for (const std::uint32_t v : geometry.slots[s]) {
                        const glm::vec3& p = geometry.vertices[v].position;
                        if (support_value(direction, p) != best.best[d]) continue;
                        if (!found || lexicographically_less(p, point)) point = p;
                        found = true;
                    }
                continue;
            }
            const bool left_first = lexicographically_less(tree.nodes[node.left].box.lo, tree.nodes[node.right].box.lo);
            stack.push_back(left_first ? node.right : node.left);
            stack.push_back(left_first ? node.left : node.right);
        }
        points[d] = point;
    }
    return points;
}

}  // namespace kerf::halfedge
