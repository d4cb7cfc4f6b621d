#include "halfedge/cut/visit_tree.h"

#include "halfedge/cut/leaf_prefetch.h"

namespace kerf::core::halfedge {

namespace {

/// The visits before it stand for nobody.
constexpr std::size_t kRoot = 2;

void prefetch_triangles(const Universe& u, const Node& leaf)
{
    prefetch(&u.slots[leaf.first], leaf.count * sizeof(Triangle));
    prefetch(&u.face_of_slot[leaf.first], leaf.count * sizeof(FaceId));
}

/// Which nodes the plane meets. Level by level, because memory is far away: a node is asked for when its parent is
/// looked at, long before its own turn. Without branches on what can't be predicted, which is where a box lies.
/// Returns the end of the visits.
std::size_t visit_levels(const Universe& u, const Plane& plane, Index shell, NodeId root,
                         std::vector<NodeVisit>& visits, BySide<bool>& present)
{
    std::size_t end = kRoot;
    visits[end++].op.node = root;
    for (std::size_t i = kRoot; i < end; ++i) {
        if (visits.size() < end + 2) visits.resize(2 * visits.size());
        const NodeId n = visits[i].op.node;
        const Node& node = u.tree.nodes[n];
        const auto [lo, hi] = plane.distance_range(node.box);
        // A box that touches the plane may hold faces in the plane, so only > and < decide.
        const bool above = lo > 0.0, below = hi < 0.0, met = !(above || below), leaf = node.is_leaf();
        present[Side::positive] |= above;
        present[Side::negative] |= below;
        visits[i].op.kind = !met ? TreeOp::Kind::whole : leaf ? TreeOp::Kind::leaf : TreeOp::Kind::join;
        visits[i].op.argument = met ? kNone : first_target(shell, static_cast<Side>(above)).number();
        if (leaf) {
            if (met) prefetch_triangles(u, node);
            visits[i].child = 0;
            continue;
        }
        visits[i].child = met ? static_cast<Index>(end) : 0;
        visits[end].op.node = node.left;
        visits[end + 1].op.node = node.right;
        end += met ? 2 : 0;
        prefetch(u.tree.nodes[node.left]);
        prefetch(u.tree.nodes[node.right]);
    }
    return end;
}

/// Writes the program: the visits up to `end` in post-order.
void write_program(std::vector<NodeVisit>& visits, std::size_t end, std::vector<TreeOp>& program)
{
    visits[0].count = visits[1].count = 0;
    for (std::size_t i = end; i-- > kRoot;)
        visits[i].count = 1 + visits[visits[i].child].count + visits[visits[i].child + 1].count;
    visits[kRoot].first_op = static_cast<Index>(program.size());
    program.resize(program.size() + visits[kRoot].count);
    for (std::size_t i = kRoot; i < end; ++i) {
        const NodeVisit visit = visits[i];
        visits[visit.child].first_op = visit.first_op;
        visits[visit.child + 1].first_op = visit.first_op + visits[visit.child].count;
        program[visit.first_op + visit.count - 1] = visit.op;
    }
}

}  // namespace

TreeVisit visit_tree(const Universe& universe, const Plane& plane, Index shell, NodeId root,
                     std::vector<NodeVisit>& visits, std::vector<TreeOp>& program)
{
    TreeVisit visit;
    const std::size_t end = visit_levels(universe, plane, shell, root, visits, visit.present);
    write_program(visits, end, program);
    visit.nodes = end - kRoot;
    return visit;
}

}  // namespace kerf::core::halfedge
