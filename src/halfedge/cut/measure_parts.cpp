#include "halfedge/cut/measure_parts.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "common/geometry/parallel_rays.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/tolerances.h"
#include "halfedge/universe/export.h"

namespace kerf::core::halfedge {

namespace {

/// Calls add(ray, term) for the crossings of rays with a subtree; boxes that no ray meets are skipped.
template <class Add>
void count_crossings_below(const Universe& u, NodeId root, const ParallelRays& rays, Add add)
{
    std::vector<NodeId> stack{root};
    while (!stack.empty()) {
        const Node& node = u.tree.nodes[stack.back()];
        stack.pop_back();
        if (!rays.may_meet(node.box)) continue;
        if (!node.is_leaf()) {
            stack.push_back(node.left);
            stack.push_back(node.right);
            continue;
        }
        for (SlotId slot = node.first; slot < node.first + node.count; ++slot) {
            const Triangle& t = u.slots[slot];
            rays.for_each_crossing(u.vertices[t[0]].position, u.vertices[t[1]].position, u.vertices[t[2]].position,
                                   add);
        }
    }
}

/// Visits what goes to the targets of a side, program by program: subtrees by `visit_node(target, node)`, single
/// triangles by `visit_triangle(target, a, b, c)`.
template <class VisitNode, class VisitTriangle>
void for_each_on_side(const Universe& u, const Found& found, const Pieces& pieces, Side side, VisitNode visit_node,
                      VisitTriangle visit_triangle)
{
    for (const CutShell& shell : found.shells)
        for (std::size_t i = shell.first_op; i < shell.first_op + shell.op_count; ++i) {
            const TreeOp& op = found.ops[i];
            if (op.kind == TreeOp::Kind::whole && pieces.target(op.target()).side == side)
                visit_node(op.target(), op.node);
            if (op.kind != TreeOp::Kind::leaf) continue;
            const Node& node = u.tree.nodes[op.node];
            for (Index e = 0; e < node.count; ++e) {
                const LeafEntry entry = found.entries[op.argument + e];
                const Triangle& t = u.slots[node.first + e];
                if (!entry.is_crossing()) {
                    if (pieces.target(entry.target()).side == side)
                        visit_triangle(entry.target(), u.vertices[t[0]].position, u.vertices[t[1]].position,
                                       u.vertices[t[2]].position);
                    continue;
                }
                const Crossing& c = found.crossings[entry.crossing()];
                const auto position = [&](std::uint8_t code) {
                    if (code == TriangleSplit::kCutNext) return c.split.cut_next.position;
                    if (code == TriangleSplit::kCutPrevious) return c.split.cut_previous.position;
                    return u.vertex(c.corner[code]).position;
                };
                for (const SubTriangle& sub : c.split.sub_triangles()) {
                    if (sub.side == side)
                        visit_triangle(c.target[side], position(sub.corners[0]), position(sub.corners[1]),
                                       position(sub.corners[2]));
                }
            }
        }
}

/// Describes a shell that is not cut by sums over its subtrees and triangles.
class WholeShell
{
public:
    explicit WholeShell(const Universe& universe) : u_(universe) {}

    void add(NodeId root)
    {
        const Node& node = u_.tree.nodes[root];
        box_.add(node.box);
        volume6_ += u_.tree.moments[root].volume6;
        roots_.push_back(root);
    }
    void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
    {
        for (const glm::vec3& p : {a, b, c}) box_.add(p);
        triangles_.push_back({a, b, c});
    }

    void describe(SurfacePart& part)
    {
        part.sample = sample();
        part.volume6 = volume6_ + sum_of_triangles(u_.reference);
        // Sums about a point far away have no digits left for what is very small; those of an open shell are about its
        // sample, and cost O(n), as do those that are not known.
        const double far = glm::length(glm::dvec3(part.sample) - u_.reference) + kReachInNoise * u_.noise;
        if (u_.has_boundary || !(std::abs(part.volume6) > kLostDigits * far * far * far)) {
            part.volume6 = sum_of_triangles(part.sample);
            MassMoments moments;
            for (const NodeId root : roots_)
                for_each_slot(u_, root, [&](SlotId slot) {
                    const Triangle& t = u_.slots[slot];
                    moments.add(part.sample, u_.vertices[t[0]].position, u_.vertices[t[1]].position,
                                u_.vertices[t[2]].position);
                });
            part.volume6 += moments.volume6;
        }
        part.is_flat = has_no_volume(part.volume6, box_, u_.noise);
    }

private:
    /// Nodes whose boxes begin behind the first corner are skipped.
    glm::vec3 sample() const
    {
        ShellSample sample;
        for (const auto& [a, b, c] : triangles_) sample.add(a, b, c);
        std::vector<NodeId> stack(roots_);
        while (!stack.empty()) {
            const Node& node = u_.tree.nodes[stack.back()];
            stack.pop_back();
            if (lexicographically_less(sample.first_corner(), node.box.lo)) continue;
            if (node.is_leaf()) {
                for (SlotId slot = node.first; slot < node.first + node.count; ++slot) {
                    const Triangle& t = u_.slots[slot];
                    sample.add(u_.vertices[t[0]].position, u_.vertices[t[1]].position, u_.vertices[t[2]].position);
                }
                continue;
            }
            NodeId nearer = node.left, other = node.right;
            if (lexicographically_less(u_.tree.nodes[other].box.lo, u_.tree.nodes[nearer].box.lo))
                std::swap(nearer, other);
            stack.push_back(other);
            stack.push_back(nearer);
        }
        return sample.point();
    }

    double sum_of_triangles(const glm::dvec3& reference) const
    {
        MassMoments moments;
        for (const auto& [a, b, c] : triangles_) moments.add(reference, a, b, c);
        return moments.volume6;
    }

    const Universe& u_;
    Box box_;
    double volume6_ = 0.0;
    std::vector<NodeId> roots_;
    std::vector<std::array<glm::vec3, 3>> triangles_;
};

}  // namespace

Index PartsOfSide::add(TargetId target)
{
    SurfacePart part;
    part.solid = solid_of(target);
    parts_.push_back(part);
    return static_cast<Index>(parts_.size() - 1);
}

/// Finds the parts that have a vertex beyond the noise, in one run over the programs.
template <class HasSeveral>
void PartsOfSide::mark_far_parts(std::vector<bool>& is_far, HasSeveral has_several) const
{
    const int sign = side_ == Side::positive ? 1 : -1;
    std::vector<NodeId> waiting;
    const auto is_beyond = [&](double distance) { return sign * distance > u_.noise; };
    for (const CutShell& shell : found_.shells) {
        if (!has_several(shell.solid)) continue;
        for (std::size_t i = shell.first_op; i < shell.first_op + shell.op_count; ++i) {
            const TreeOp& op = found_.ops[i];
            if (op.kind == TreeOp::Kind::whole) {
                const Index part = of_target(op.target());
                if (part != kNone && !is_far[part])
                    is_far[part] = reaches_beyond(u_.tree, u_.geometry(), op.node, plane_, u_.noise, sign, waiting,
                                                  found_.nodes_visited);
            }
            if (op.kind != TreeOp::Kind::leaf) continue;
            const Node& node = u_.tree.nodes[op.node];
            for (Index e = 0; e < node.count; ++e) {
                const LeafEntry entry = found_.entries[op.argument + e];
                const bool crosses = entry.is_crossing();
                const Crossing* const c = crosses ? &found_.crossings[entry.crossing()] : nullptr;
                const Index part = of_target(crosses ? c->target[side_] : entry.target());
                if (part == kNone || is_far[part]) continue;
                if (!crosses) {
                    for (const Index v : u_.slots[node.first + e])
                        if (is_beyond(plane_.signed_distance(u_.vertices[v].position))) is_far[part] = true;
                    continue;
                }
                for (const SubTriangle& t : c->split.sub_triangles())
                    for (const std::uint8_t code : t.corners)
                        if (t.side == side_ && code < 3 && is_beyond(c->distance[code])) is_far[part] = true;
            }
        }
    }
}

void PartsOfSide::list(DisjointSets& same)
{
    of_target_.assign(pieces_.targets.size(), kNone);
    for (Index t = 0; t < pieces_.targets.size(); ++t) {
        if (pieces_.targets[t].side != side_ || pieces_.targets[t].is_empty) continue;
        Index& part = of_target_[same.find(t)];
        if (part == kNone) part = add(TargetId(t));
        of_target_[t] = part;
    }
    // What has vanished is with what is left of its solid. A solid of which nothing is left makes no fragment.
    std::unordered_map<std::uint32_t, Index> first_of_solid;
    for (Index t = 0; t < pieces_.targets.size(); ++t) {
        if (pieces_.targets[t].side != side_ || !pieces_.targets[t].is_empty) continue;
        if (first_of_solid.empty())
            for (Index part = 0; part < parts_.size(); ++part) first_of_solid.emplace(parts_[part].solid, part);
        const auto [entry, is_new] = first_of_solid.try_emplace(solid_of(TargetId(t)), kNone);
        if (is_new) entry->second = add(TargetId(t));
        of_target_[t] = entry->second;
    }
    cut_count_ = static_cast<Index>(parts_.size());
    for (const ShellRoot& shell : whole_) {
        SurfacePart part;
        part.solid = shell.solid;
        parts_.push_back(part);
    }
}

void PartsOfSide::measure()
{
    std::vector<std::uint32_t> solids;
    for (const SurfacePart& part : parts_) solids.push_back(part.solid);
    std::sort(solids.begin(), solids.end());
    const auto has_several = [&](std::uint32_t solid) {
        const auto [first, last] = std::equal_range(solids.begin(), solids.end(), solid);
        return last - first > 1;
    };
    std::vector<bool> is_far(parts_.size(), false);
    mark_far_parts(is_far, has_several);
    std::vector<Index> whole_number(parts_.size(), kNone);  // of those that are not cut
    std::vector<WholeShell> shells;
    for (Index i = 0; i < parts_.size(); ++i) {
        SurfacePart& part = parts_[i];
        if (!has_several(part.solid)) continue;
        if (part.is_cut) {
            part.is_flat = !is_far[i];
            continue;
        }
        whole_number[i] = static_cast<Index>(shells.size());
        shells.emplace_back(u_);
        if (i >= cut_count_) shells.back().add(whole_[i - cut_count_].root);
    }
    if (shells.empty()) return;
    const auto shell_at = [&](TargetId target) {
        const Index number = whole_number[of_target(target)];
        return number == kNone ? nullptr : &shells[number];
    };
    // Only what an earlier cut has left in parts holds whole shells beside what is cut.
    if (std::any_of(whole_number.begin(), whole_number.begin() + cut_count_, [](Index n) { return n != kNone; }))
        for_each_on_side(
            u_, found_, pieces_, side_,
            [&](TargetId target, NodeId node) {
                if (WholeShell* const shell = shell_at(target)) shell->add(node);
            },
            [&](TargetId target, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
                if (WholeShell* const shell = shell_at(target)) shell->add(a, b, c);
            });
    for (Index i = 0; i < parts_.size(); ++i)
        if (whole_number[i] != kNone) shells[whole_number[i]].describe(parts_[i]);
}

void PartsOfSide::count_crossings(std::span<const AxisRay> rays, const std::vector<bool>& is_wanted,
                                  const AddCrossing& add) const
{
    const ParallelRays bundle(rays);
    const auto add_to = [&](Index part) { return [&add, part](std::uint32_t ray, int term) { add(part, ray, term); }; };
    for_each_on_side(
        u_, found_, pieces_, side_,
        [&](TargetId target, NodeId node) {
            if (is_wanted[of_target(target)]) count_crossings_below(u_, node, bundle, add_to(of_target(target)));
        },
        [&](TargetId target, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
            if (is_wanted[of_target(target)]) bundle.for_each_crossing(a, b, c, add_to(of_target(target)));
        });
    for (Index i = 0; i < whole_.size(); ++i)
        if (is_wanted[cut_count_ + i]) count_crossings_below(u_, whole_[i].root, bundle, add_to(cut_count_ + i));
}

void PartsOfSide::make_piece_shells(const std::vector<std::uint32_t>& piece, Pieces& pieces) const
{
    Index count = 0;
    for (const std::uint32_t p : piece) count = std::max(count, p + 1);
    std::vector<Index> piece_shell(count, kNone);
    for (Index t = 0; t < of_target_.size(); ++t) {
        if (of_target_[t] == kNone) continue;
        const std::uint32_t p = piece[of_target_[t]];
        if (piece_shell[p] == kNone) {
            PieceShell made;
            made.side = side_;
            made.solid = solid_of(TargetId(t));
            made.fragment = p;
            piece_shell[p] = static_cast<Index>(pieces.shells.size());
            pieces.shells.push_back(made);
        }
        pieces.targets[t].piece_shell = piece_shell[p];
    }
    pieces.whole_fragment[side_].assign(piece.begin() + cut_count_, piece.end());
    pieces.fragment_count[side_] = count;
}

}  // namespace kerf::core::halfedge
