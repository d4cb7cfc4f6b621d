#include "halfedge/cut/cut_plan.h"

// FIND: which subtrees lie wholly on one side, and which triangles cross the plane. O(s log(n / s)) nodes for s leaves
// whose box meets the plane.

namespace kerf::halfedge {

namespace {

/// The side that a face which does not cross is kept on.
Side kept_side(const Plane& plane, const std::array<glm::vec3, 3>& p, const std::array<double, 3>& d)
{
    switch (classify(d[0], d[1], d[2])) {
        case TriangleClass::negative:
            return Side::negative;
        case TriangleClass::in_plane:
            return coplanar_side(plane, p[0], p[1], p[2]);
        case TriangleClass::positive:
        case TriangleClass::crossing:
            break;
    }
    return Side::positive;
}

class Finder
{
public:
    Finder(Universe& universe, const Plane& plane, Index shell, CutScratch& scratch)
        : u_(universe), plane_(plane), shell_(shell), s_(scratch)
    {
    }

    BySide<bool> run(Index root)
    {
        const std::size_t first_op = s_.ops.size();
        traverse(root);
        open_leaves(first_op);
        return present_;
    }

private:
    /// Writes the program; leaves that the plane meets wait for open_leaves().
    void traverse(Index root)
    {
        const auto visit_later = [&](Index n, bool children_done) {
            s_.stack.push_back({n, children_done});
            __builtin_prefetch(&u_.tree.nodes[n]);
        };
        s_.stack.assign(1, {root, false});
        while (!s_.stack.empty()) {
            const auto [n, children_done] = s_.stack.back();
            s_.stack.pop_back();
            if (children_done) {
                s_.ops.push_back({TreeOp::Kind::join, n, kNone});
                continue;
            }
            ++s_.nodes_visited;
            const Node& node = u_.tree.nodes[n];
            const auto [lo, hi] = plane_.distance_range(node.box);
            // A box that touches the plane may hold faces in the plane, so only > and < decide.
            if (lo > 0.0) {
                s_.ops.push_back(whole(n, Side::positive));
            } else if (hi < 0.0) {
                s_.ops.push_back(whole(n, Side::negative));
            } else if (node.is_leaf()) {
                s_.ops.push_back({TreeOp::Kind::leaf, n, kNone});
                prefetch(&u_.slots[node.first], node.count * sizeof(Triangle));
            } else {
                s_.stack.push_back({n, true});
                visit_later(node.right, false);
                visit_later(node.left, false);
            }
        }
    }

    /// Memory is far away and a leaf's vertices lie anywhere: those of the leaves to come are asked for in time.
    void open_leaves(std::size_t first_op)
    {
        std::size_t ahead = first_op;
        const auto next_leaf = [&] {
            while (ahead < s_.ops.size() && s_.ops[ahead].kind != TreeOp::Kind::leaf) ++ahead;
            if (ahead == s_.ops.size()) return;
            const Node& node = u_.tree.nodes[s_.ops[ahead++].node];
            for (Index slot = node.first; slot < node.first + node.count; ++slot) {
                __builtin_prefetch(&u_.vertices[u_.slots[slot][0]]);
                __builtin_prefetch(&u_.vertices[u_.slots[slot][1]]);
            }
            prefetch(&u_.face_of_slot[node.first], node.count * sizeof(Index));
        };
        for (int i = 0; i < kLeavesAhead; ++i) next_leaf();
        for (std::size_t i = first_op; i < s_.ops.size(); ++i) {
            if (s_.ops[i].kind != TreeOp::Kind::leaf) continue;
            next_leaf();
            s_.ops[i] = open_leaf(s_.ops[i].node);
        }
    }

    static void prefetch(const void* begin, std::size_t bytes)
    {
        constexpr std::size_t kCacheLine = 64;
        for (std::size_t i = 0; i < bytes; i += kCacheLine) __builtin_prefetch(static_cast<const char*>(begin) + i);
    }

    static constexpr int kLeavesAhead = 3;

    Index target(Side side) const { return first_target(shell_, side); }

    TreeOp whole(Index n, Side side)
    {
        present_[side] = true;
        return {TreeOp::Kind::whole, n, target(side)};
    }

    TreeOp open_leaf(Index n)
    {
        const Node& node = u_.tree.nodes[n];
        const Plane plane = plane_;
        const Vertex* const vertices = u_.vertices.data();
        const std::size_t first_entry = s_.entries.size();
        s_.entries.resize(first_entry + node.count);
        LeafEntry* const entries = &s_.entries[first_entry];
        BySide<std::uint32_t> kept{};
        std::uint32_t crossing = 0;
        for (Index slot = node.first; slot < node.first + node.count; ++slot) {
            const Triangle& t = u_.slots[slot];
            const std::array<double, 3> d{plane.signed_distance(vertices[t[0]].position),
                                          plane.signed_distance(vertices[t[1]].position),
                                          plane.signed_distance(vertices[t[2]].position)};
            // What classify() says, without branches: which side a triangle is on can't be predicted here.
            const bool above = (unsigned{d[0] > 0.0} | unsigned{d[1] > 0.0} | unsigned{d[2] > 0.0}) != 0;
            const bool below = (unsigned{d[0] < 0.0} | unsigned{d[1] < 0.0} | unsigned{d[2] < 0.0}) != 0;
            if (above & below) {
                entries[slot - node.first] = LeafEntry::to_crossing(static_cast<Index>(s_.crossings.size()));
                add_crossing(slot, node.group, t, d);
                ++crossing;
                continue;
            }
            const bool on = (unsigned{d[0] == 0.0} | unsigned{d[1] == 0.0} | unsigned{d[2] == 0.0}) != 0;
            const Side side =
                on ? kept_side(plane, {vertices[t[0]].position, vertices[t[1]].position, vertices[t[2]].position}, d)
                   : static_cast<Side>(above);
            ++kept[side];
            entries[slot - node.first] = LeafEntry::to_target(target(side));
            if (on && (d[0] == 0.0) + (d[1] == 0.0) + (d[2] == 0.0) >= 2)
                add_in_plane_edges(u_.face_of_slot[slot], side, t, d, node.group);
        }
        if (crossing == 0 && (kept[Side::negative] == 0 || kept[Side::positive] == 0)) {
            s_.entries.resize(first_entry);
            s_.triangles_read += node.count;
            return whole(n, kept[Side::negative] == 0 ? Side::positive : Side::negative);
        }
        for (const Side side : kSides) present_[side] |= crossing > 0 || kept[side] > 0;
        return {TreeOp::Kind::leaf, n, static_cast<Index>(first_entry)};
    }

    void add_crossing(Index slot, Index group, const Triangle& t, const std::array<double, 3>& d)
    {
        Crossing& c = s_.crossings.add();
        c.slot = slot;
        c.face = u_.face_of_slot[slot];
        c.group = group;
        c.shell = shell_;
        c.target = {target(Side::negative), target(Side::positive)};
        c.bounds_nothing = {};
        c.corner = t;
        c.distance = d;
        u_.stamp_of_face[c.face] = static_cast<Index>(u_.stamp_base + s_.crossings.size() - 1);
    }

    /// Edges in the plane at a face, each once: by the face on the negative side where the two are kept on different
    /// sides, by the one of the smaller half-edge otherwise.
    void add_in_plane_edges(Index face, Side side, const Triangle& t, const std::array<double, 3>& d, Index group)
    {
        Index h = u_.mesh.halfedge_of_face(face);
        for (std::size_t i = 0; i < 3; ++i, h = u_.mesh.next(h)) {
            if (d[i] != 0.0 || d[(i + 1) % 3] != 0.0) continue;
            const Index neighbour = u_.mesh.face(h ^ 1u);
            const bool is_flush = neighbour == kNone || side_of_face(neighbour) == side;
            if (is_flush && (neighbour == kNone || h < (h ^ 1u))) s_.flush.push_back({h, face, side, target(side)});
            if (is_flush || side == Side::positive) continue;
            s_.in_plane.push_back({h,
                                   h ^ 1u,
                                   face,
                                   neighbour,
                                   group,
                                   shell_,
                                   t[(i + 1) % 3],
                                   {target(Side::negative), target(Side::positive)}});
        }
    }

    Side side_of_face(Index face) const
    {
        std::array<glm::vec3, 3> p;
        std::array<double, 3> d;
        Index h = u_.mesh.halfedge_of_face(face);
        for (std::size_t i = 0; i < 3; ++i, h = u_.mesh.next(h)) {
            p[i] = u_.mesh.point(u_.mesh.from(h));
            d[i] = plane_.signed_distance(p[i]);
        }
        return kept_side(plane_, p, d);
    }

    Universe& u_;
    const Plane& plane_;
    const Index shell_;
    CutScratch& s_;
    BySide<bool> present_{};
};

}  // namespace

BySide<bool> find(Universe& universe, Index root, const Plane& plane, Index shell_index, CutScratch& scratch)
{
    return Finder(universe, plane, shell_index, scratch).run(root);
}

}  // namespace kerf::halfedge
