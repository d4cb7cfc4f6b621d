#include "support/check_universe.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/support_points.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace kerf::core::halfedge {

namespace {

class Checker
{
public:
    explicit Checker(const Universe& universe)
        : u_(universe), face_used_(u_.mesh.faces()), slot_used_(u_.slots.size()), outgoing_(u_.mesh.points())
    {
    }

    std::string run(std::span<const ShellRoot> shells)
    {
        for (const ShellRoot& shell : shells) {
            if (!shell.root.is_valid() || shell.root.number() >= u_.tree.nodes.size()) return "a shell has no root";
            if (!check_subtree(shell.root)) return error_;
        }
        for (std::size_t face = 0; face < face_used_.size(); ++face)
            if (face_used_[face] && !check_neighbours(FaceId(int(face)))) return error_;
        for (std::size_t point = 0; point < outgoing_.size(); ++point)
            if (outgoing_[point] > 0 && !check_vertex_fan(PointId(int(point)))) return error_;
        return {};
    }

private:
    bool fail(const std::string& what)
    {
        error_ = what;
        return false;
    }
    static std::string number(Index i) { return std::to_string(i); }
    template <class Id>
    static std::string number(Id id)
    {
        return std::to_string(number_of(id));
    }

    bool check_subtree(NodeId n)
    {
        const Node& node = u_.tree.nodes[n];
        if (!node.is_leaf()) {
            const Node &l = u_.tree.nodes[node.left], &r = u_.tree.nodes[node.right];
            if (!check_subtree(node.left) || !check_subtree(node.right)) return false;
            if (node.count != l.count + r.count) return fail("node " + number(n) + " counts wrongly");
            if (!node.is_mixed() && (l.group != node.group || r.group != node.group || l.first != node.first ||
                                     l.first + l.count != r.first))
                return fail("node " + number(n) + " is no run");
            Box box = l.box;
            box.add(r.box);
            MassMoments moments = u_.tree.moments[node.left];
            moments.add(u_.tree.moments[node.right]);
            Support support = u_.tree.supports[node.left];
            support.add(u_.tree.supports[node.right]);
            return check_sums(n, box, moments, support);
        }
        if (number_of(node.group) >= u_.groups.size()) return fail("leaf " + number(n) + " has no group");
        Box box;
        MassMoments moments;
        Support support = Support::none();
        for (SlotId slot = node.first; slot < node.first + node.count; ++slot) {
            if (slot.number() >= u_.slots.size())
                return fail("leaf " + number(n) + " names a slot that does not exist");
            if (slot_used_[slot.number()]) return fail("slot " + number(slot) + " occurs twice");
            slot_used_[slot.number()] = true;
            const Triangle& t = u_.slots[slot];
            for (const Index v : t) {
                if (v >= u_.vertices.size())
                    return fail("slot " + number(slot) + " names a vertex that does not exist");
                box.add(u_.vertices[v].position);
                for (std::size_t d = 0; d < kSupportDirections; ++d)
                    support.best[d] =
                        std::max(support.best[d], support_value(support_directions()[d], u_.vertices[v].position));
            }
            moments.add(u_.reference, u_.vertices[t[0]].position, u_.vertices[t[1]].position,
                        u_.vertices[t[2]].position);
            if (!check_face(slot)) return false;
        }
        return check_sums(n, box, moments, support);
    }

    bool check_sums(NodeId n, const Box& box, const MassMoments& moments, const Support& support)
    {
        const Box& have = u_.tree.nodes[n].box;
        if (have.lo != box.lo || have.hi != box.hi) return fail("node " + number(n) + " has a wrong box");
        if (u_.tree.supports[n].best != support.best) return fail("node " + number(n) + " has wrong maxima");
        // The order of the additions may differ: rounding is relative to what is added up, which may cancel. The
        // numbers in front are those of the tetrahedra's sums (mass_properties.h).
        const glm::dvec3 far =
            glm::max(glm::abs(glm::dvec3(box.lo) - u_.reference), glm::abs(glm::dvec3(box.hi) - u_.reference));
        const double r = glm::length(far);
        constexpr double kRounding = 1e-9;
        const auto near = [&](double x, double y, double largest) {
            return std::abs(x - y) <= kRounding * largest + std::numeric_limits<double>::min();
        };
        const MassMoments& m = u_.tree.moments[n];
        // Those of a leaf may be unknown, and those of what has it under it are then.
        if (!moments.are_known())
            return !m.are_known() || fail("node " + number(n) + " knows moments of what has none");
        if (!m.are_known() && u_.tree.nodes[n].is_leaf()) return true;
        bool same = near(m.volume6, moments.volume6, 6 * r * r * r);
        for (int i = 0; i < 3; ++i)
            same = same && near(m.first24[i], moments.first24[i], 24 * r * r * r * r) &&
                   near(m.squares120[i], moments.squares120[i], 120 * r * r * r * r * r) &&
                   near(m.products120[i], moments.products120[i], 120 * r * r * r * r * r);
        return same || fail("node " + number(n) + " has wrong moments");
    }

    bool check_face(SlotId slot)
    {
        const FaceId face = u_.face_of_slot[slot];
        if (number_of(face) >= u_.mesh.faces()) return fail("slot " + number(slot) + " has no face");
        if (face_used_[number_of(face)]) return fail("face " + number(face) + " occurs twice");
        face_used_[number_of(face)] = true;
        HalfedgeId h = u_.mesh.halfedge_of(face);
        if (!h.is_valid()) return fail("face " + number(face) + " is dead");
        const HalfedgeId start = h;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (u_.mesh.face(h) != face)
                return fail("half-edge " + number(h) + " has another face than " + number(face));
            if (u_.mesh.prev(u_.mesh.next(h)) != h)
                return fail("half-edge " + number(h) + " is not before its next one");
            if (number_of(u_.mesh.to(h)) >= u_.mesh.points()) return fail("half-edge " + number(h) + " has no point");
            if (u_.mesh.from(h) != u_.mesh.to(u_.mesh.prev(h)))
                return fail("half-edge " + number(h) + " does not start where the one before ends");
            const PointId point = u_.mesh.from(h);
            ++outgoing_[number_of(point)];
            if (u_.mesh.position(point) != u_.vertices[u_.slots[slot][corner]].position)
                return fail("corner " + number(static_cast<Index>(corner)) + " of slot " + number(slot) +
                            " is not where its point is");
            h = u_.mesh.next(h);
        }
        return h == start || fail("face " + number(face) + " is no triangle");
    }

    bool check_neighbours(FaceId face)
    {
        HalfedgeId h = u_.mesh.halfedge_of(face);
        for (int i = 0; i < 3; ++i, h = u_.mesh.next(h)) {
            const HalfedgeId outer = opposite(h);
            const FaceId neighbour = u_.mesh.face(outer);
            if (neighbour.is_valid()) {
                if (number_of(neighbour) >= face_used_.size() || !face_used_[number_of(neighbour)])
                    return fail("face " + number(face) + " has neighbour " + number(neighbour) +
                                ", which is not in the fragment");
                continue;
            }
            if (u_.mesh.prev(u_.mesh.next(outer)) != outer || !u_.mesh.is_boundary(u_.mesh.next(outer)))
                return fail("boundary half-edge " + number(outer) + " is not linked");
            if (u_.mesh.from(u_.mesh.next(outer)) != u_.mesh.to(outer))
                return fail("boundary half-edge " + number(outer) + " does not end where the next one starts");
        }
        return true;
    }

    bool check_vertex_fan(PointId point)
    {
        const HalfedgeId start = u_.mesh.halfedge_of(point);
        if (!start.is_valid()) return fail("point " + number(point) + " has no half-edge");
        if (u_.mesh.from(start) != point) return fail("the half-edge of point " + number(point) + " starts elsewhere");
        Index count = 0;
        bool boundary = false;
        for_each_outgoing(u_.mesh, start, [&](HalfedgeId h) {
            if (u_.mesh.is_boundary(h))
                boundary = true;
            else
                ++count;
        });
        if (count != outgoing_[number_of(point)])
            return fail("point " + number(point) + " has more than one vertex fan");
        return !boundary || u_.mesh.is_boundary(start) ||
               fail("boundary point " + number(point) + " does not name its boundary half-edge");
    }

    const Universe& u_;
    std::vector<bool> face_used_, slot_used_;
    std::vector<Index> outgoing_;  // half-edges with a face that leave each point
    std::string error_;
};

}  // namespace

std::string check_universe(const Universe& universe, std::span<const ShellRoot> shells)
{
    return Checker(universe).run(shells);
}

}  // namespace kerf::core::halfedge
