#include "halfedge/cut/visit_leaves.h"

#include "halfedge/cut/leaf_prefetch.h"

namespace kerf::core::halfedge {

namespace {

/// The visits before it stand for nobody.
constexpr std::size_t kFirstVisit = 2;

/// Level by level, because memory is far away: a node is asked for when its parent is looked at, long before its own turn.
/// Without branches on what can't be predicted, which is where a box lies. Returns the end of the visits.
std::size_t visit_levels(const Universe& u, const Plane& plane, NodeId root, std::vector<LeafVisit>& visits)
{
    constexpr std::size_t kFewVisits = 64;
    if (visits.size() < kFewVisits) visits.resize(kFewVisits);
    std::size_t end = kFirstVisit;
    visits[end++].node = root;
    for (std::size_t i = kFirstVisit; i < end; ++i) {
        if (visits.size() < end + 2) visits.resize(2 * visits.size());
        const Node& node = u.tree.nodes[visits[i].node];
        const auto [lo, hi] = plane.distance_range(node.box);
        // A box that touches the plane may hold faces in the plane, so only > and < decide.
        const bool met = !(lo > 0.0 || hi < 0.0);
        visits[i].is_leaf = met && node.is_leaf();
        if (node.is_leaf()) {
            if (met) prefetch(&u.slots[node.first], node.count * sizeof(Triangle));
            visits[i].child = 0;
            continue;
        }
        visits[i].child = met ? static_cast<Index>(end) : 0;
        visits[end].node = node.left;
        visits[end + 1].node = node.right;
        end += met ? 2 : 0;
        prefetch(u.tree.nodes[node.left]);
        prefetch(u.tree.nodes[node.right]);
    }
    return end;
}

}  // namespace

std::size_t visit_leaves(const Universe& u, const Plane& plane, NodeId root, std::vector<LeafVisit>& visits,
                         std::vector<NodeId>& leaves)
{
    const std::size_t end = visit_levels(u, plane, root, visits);
    visits[0].leaves = visits[1].leaves = 0;
    for (std::size_t i = end; i-- > kFirstVisit;)
        visits[i].leaves =
            Index{visits[i].is_leaf} + visits[visits[i].child].leaves + visits[visits[i].child + 1].leaves;
    const std::size_t first_leaf = leaves.size(), count = visits[kFirstVisit].leaves;
    // What is no leaf is written behind the list: there is no branch to mispredict.
    leaves.resize(first_leaf + count + 1);
    visits[kFirstVisit].first = 0;
    for (std::size_t i = kFirstVisit; i < end; ++i) {
        const LeafVisit visit = visits[i];
        visits[visit.child].first = visit.first;
        visits[visit.child + 1].first = visit.first + visits[visit.child].leaves;
        leaves[first_leaf + (visit.is_leaf ? visit.first : count)] = visit.node;
    }
    leaves.pop_back();
    return end - kFirstVisit;
}

}  // namespace kerf::core::halfedge
