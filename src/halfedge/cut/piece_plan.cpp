#include "halfedge/cut/piece_plan.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "common/cutting/pieces.h"
#include "common/geometry/disjoint_sets.h"
#include "common/geometry/parallel_rays.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/tolerances.h"
#include "halfedge/cut/outline.h"
#include "halfedge/universe/export.h"

namespace kerf::halfedge {

namespace {

/// Calls add(ray, term) for the crossings of rays with a subtree; boxes that no ray meets are skipped.
template <class Add>
void count_crossings(const Universe& u, Index root, const ParallelRays& rays, Add add)
{
    std::vector<Index> stack{root};
    while (!stack.empty()) {
        const Node& node = u.tree.nodes[stack.back()];
        stack.pop_back();
        if (!rays.may_meet(node.box)) continue;
        if (!node.is_leaf()) {
            stack.push_back(node.left);
            stack.push_back(node.right);
            continue;
        }
        for (Index slot = node.first; slot < node.first + node.count; ++slot) {
            const Triangle& t = u.slots[slot];
            rays.for_each_crossing(u.vertices[t[0]].position, u.vertices[t[1]].position, u.vertices[t[2]].position,
                                   add);
        }
    }
}

/// Visits what goes to the targets of a side, program by program: subtrees by `visit_node(target, node)`, single
/// triangles by `visit_triangle(target, a, b, c)`.
template <class VisitNode, class VisitTriangle>
void for_each_on_side(const Universe& u, const CutScratch& s, Side side, VisitNode visit_node,
                      VisitTriangle visit_triangle)
{
    for (const CutShell& shell : s.cut_shells)
        for (std::size_t i = shell.first_op; i < shell.first_op + shell.op_count; ++i) {
            const TreeOp& op = s.ops[i];
            if (op.kind == TreeOp::Kind::whole && s.targets[op.argument].side == side) visit_node(op.argument, op.node);
            if (op.kind != TreeOp::Kind::leaf) continue;
            const Node& node = u.tree.nodes[op.node];
            for (Index e = 0; e < node.count; ++e) {
                const Index entry = s.entries[op.argument + e];
                const Triangle& t = u.slots[node.first + e];
                if (entry < kCrossingEntry) {
                    if (s.targets[entry].side == side)
                        visit_triangle(entry, u.vertices[t[0]].position, u.vertices[t[1]].position,
                                       u.vertices[t[2]].position);
                    continue;
                }
                const Crossing& c = s.crossings[entry - kCrossingEntry];
                const auto position = [&](std::uint8_t code) {
                    if (code == TriangleSplit::kCutNext) return c.split.cut_next.position;
                    if (code == TriangleSplit::kCutPrevious) return c.split.cut_previous.position;
                    return u.vertices[c.corner[code]].position;
                };
                for (const SubTriangle& piece : c.split.sub_triangles()) {
                    if (piece.side == side)
                        visit_triangle(c.target[side], position(piece.corners[0]), position(piece.corners[1]),
                                       position(piece.corners[2]));
                }
            }
        }
}

/// Describes a shell that is not cut by sums over its subtrees and triangles.
class WholeShell
{
public:
    explicit WholeShell(const Universe& universe) : u_(universe) {}

    void add(Index root)
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
        // sample, and cost O(n).
        const double far = glm::length(glm::dvec3(part.sample) - u_.reference) + kUnitsAcross * u_.noise;
        if (u_.has_boundary || std::abs(part.volume6) <= kLostDigits * far * far * far) {
            part.volume6 = sum_of_triangles(part.sample);
            MassMoments moments;
            for (const Index root : roots_)
                for_each_slot(u_, root, [&](Index slot) {
                    const Triangle& t = u_.slots[slot];
                    moments.add(part.sample, u_.vertices[t[0]].position, u_.vertices[t[1]].position,
                                u_.vertices[t[2]].position);
                });
            part.volume6 += moments.volume6;
        }
        part.is_flat = has_no_volume(part.volume6, box_, u_.noise);
    }

private:
    static constexpr double kUnitsAcross = 0x1p20;  ///< noise units that a mesh reaches from the origin

    /// Nodes whose boxes begin behind the first corner are skipped.
    glm::vec3 sample() const
    {
        ShellSample sample;
        for (const auto& [a, b, c] : triangles_) sample.add(a, b, c);
        std::vector<Index> stack(roots_);
        while (!stack.empty()) {
            const Node& node = u_.tree.nodes[stack.back()];
            stack.pop_back();
            if (lexicographically_less(sample.first_corner(), node.box.lo)) continue;
            if (node.is_leaf()) {
                for (Index slot = node.first; slot < node.first + node.count; ++slot) {
                    const Triangle& t = u_.slots[slot];
                    sample.add(u_.vertices[t[0]].position, u_.vertices[t[1]].position, u_.vertices[t[2]].position);
                }
                continue;
            }
            Index nearer = node.left, other = node.right;
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
    std::vector<Index> roots_;
    std::vector<std::array<glm::vec3, 3>> triangles_;
};

/// The parts of one side: what hangs together by edges.
class PartsOfSide
{
public:
    PartsOfSide(const Universe& universe, const Plane& plane, Side side, const std::vector<ShellRoot>& whole,
                CutScratch& scratch)
        : u_(universe), plane_(plane), side_(side), whole_(whole), s_(scratch)
    {
    }

    /// Numbers the parts: targets first, then whole shells. `same` are targets that are one part.
    void list(DisjointSets& same)
    {
        of_target_.assign(s_.targets.size(), kNone);
        for (Index t = 0; t < s_.targets.size(); ++t) {
            if (s_.targets[t].side != side_ || s_.targets[t].is_empty) continue;
            Index& part = of_target_[same.find(t)];
            if (part == kNone) part = add(t);
            of_target_[t] = part;
        }
        // What has vanished is with what is left of its solid. A solid of which nothing is left makes no fragment.
        std::unordered_map<std::uint32_t, Index> first_of_solid;
        for (Index t = 0; t < s_.targets.size(); ++t) {
            if (s_.targets[t].side != side_ || !s_.targets[t].is_empty) continue;
            if (first_of_solid.empty())
                for (Index part = 0; part < parts_.size(); ++part) first_of_solid.emplace(parts_[part].solid, part);
            const auto [entry, is_new] = first_of_solid.try_emplace(solid_of(t), kNone);
            if (is_new) entry->second = add(t);
            of_target_[t] = entry->second;
        }
        cut_count_ = static_cast<Index>(parts_.size());
        for (const ShellRoot& shell : whole_) {
            SurfacePart part;
            part.solid = shell.solid;
            parts_.push_back(part);
        }
    }

    void mark_cut(Index part) { parts_[part].is_cut = true; }

    /// Measures what group_pieces() may ask for: nothing where each solid is in one part.
    void measure()
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
        const auto shell_at = [&](Index target) {
            const Index number = whole_number[of_target_[target]];
            return number == kNone ? nullptr : &shells[number];
        };
        // Only what an earlier cut has left in parts holds whole shells beside what is cut.
        if (std::any_of(whole_number.begin(), whole_number.begin() + cut_count_, [](Index n) { return n != kNone; }))
            for_each_on_side(
                u_, s_, side_,
                [&](Index target, Index node) {
                    if (WholeShell* const shell = shell_at(target)) shell->add(node);
                },
                [&](Index target, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
                    if (WholeShell* const shell = shell_at(target)) shell->add(a, b, c);
                });
        for (Index i = 0; i < parts_.size(); ++i)
            if (whole_number[i] != kNone) shells[whole_number[i]].describe(parts_[i]);
    }

    void count_crossings(std::span<const AxisRay> rays, const std::vector<bool>& is_wanted,
                         const AddCrossing& add) const
    {
        const ParallelRays piece_shell(rays);
        const auto add_to = [&](Index part) {
            return [&add, part](std::uint32_t ray, int term) { add(part, ray, term); };
        };
        for_each_on_side(
            u_, s_, side_,
            [&](Index target, Index node) {
                if (is_wanted[of_target_[target]])
                    halfedge::count_crossings(u_, node, piece_shell, add_to(of_target_[target]));
            },
            [&](Index target, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
                if (is_wanted[of_target_[target]]) piece_shell.for_each_crossing(a, b, c, add_to(of_target_[target]));
            });
        for (Index i = 0; i < whole_.size(); ++i)
            if (is_wanted[cut_count_ + i])
                halfedge::count_crossings(u_, whole_[i].root, piece_shell, add_to(cut_count_ + i));
    }

    /// Makes a piece shell of the targets of each piece.
    Index make_piece_shells(const std::vector<std::uint32_t>& piece, CutScratch& s,
                            std::vector<Index>& whole_fragment) const
    {
        Index count = 0;
        for (const std::uint32_t p : piece) count = std::max(count, p + 1);
        std::vector<Index> piece_shell(count, kNone);
        for (Index t = 0; t < of_target_.size(); ++t) {
            if (of_target_[t] == kNone) continue;
            const std::uint32_t p = piece[of_target_[t]];
            if (piece_shell[p] == kNone) {
                PieceShell b;
                b.side = side_;
                b.solid = solid_of(t);
                b.fragment = p;
                piece_shell[p] = static_cast<Index>(s.piece_shells.size());
                s.piece_shells.push_back(b);
            }
            s.targets[t].piece_shell = piece_shell[p];
        }
        whole_fragment.assign(piece.begin() + cut_count_, piece.end());
        return count;
    }

    Index of_target(Index target) const { return of_target_[target]; }
    const std::vector<SurfacePart>& parts() const { return parts_; }

private:
    std::uint32_t solid_of(Index target) const { return s_.cut_shells[s_.targets[target].shell].solid; }

    Index add(Index target)
    {
        SurfacePart part;
        part.solid = solid_of(target);
        parts_.push_back(part);
        return static_cast<Index>(parts_.size() - 1);
    }

    /// Finds the parts that have a vertex beyond the noise, in one run over the programs.
    template <class HasSeveral>
    void mark_far_parts(std::vector<bool>& is_far, HasSeveral has_several) const
    {
        const int sign = side_ == Side::positive ? 1 : -1;
        const auto is_beyond = [&](double distance) { return sign * distance > u_.noise; };
        for (const CutShell& shell : s_.cut_shells) {
            if (!has_several(shell.solid)) continue;
            for (std::size_t i = shell.first_op; i < shell.first_op + shell.op_count; ++i) {
                const TreeOp& op = s_.ops[i];
                if (op.kind == TreeOp::Kind::whole) {
                    const Index part = of_target_[op.argument];
                    if (part != kNone && !is_far[part])
                        is_far[part] =
                            reaches_beyond(u_.tree, u_.geometry(), op.node, plane_, u_.noise, sign, s_.nodes_visited);
                }
                if (op.kind != TreeOp::Kind::leaf) continue;
                const Node& node = u_.tree.nodes[op.node];
                for (Index e = 0; e < node.count; ++e) {
                    const Index entry = s_.entries[op.argument + e];
                    const bool crosses = entry >= kCrossingEntry;
                    const Crossing* const c = crosses ? &s_.crossings[entry - kCrossingEntry] : nullptr;
                    const Index part = of_target_[crosses ? c->target[side_] : entry];
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

    const Universe& u_;
    const Plane& plane_;
    const Side side_;
    const std::vector<ShellRoot>& whole_;
    CutScratch& s_;
    std::vector<SurfacePart> parts_;
    std::vector<Index> of_target_;
    Index cut_count_ = 0;
};

/// The outline as group_pieces() wants it.
struct PiecesOutline
{
    std::vector<glm::vec3> points;
    std::vector<OutlineEdge> edges;
};

PiecesOutline outline_of(const Universe& u, const CutScratch& s, BySide<PartsOfSide>& sides)
{
    PiecesOutline outline;
    const auto bound = [&](OutlineEdge& edge, OutlineEdgeId outline_edge) {
        for (const Side side : kSides) {
            edge.part[side] = kNoPart;
            if (s.bounds_nothing(outline_edge, side)) continue;
            edge.part[side] = sides[side].of_target(s.target_of(outline_edge, side));
            sides[side].mark_cut(edge.part[side]);
        }
    };
    if (s.irregular) {
        outline.points = s.outline_points;
        outline.edges = outline_edges(u, s);
        for (std::size_t i = 0; i < s.outline.size(); ++i) bound(outline.edges[i], s.outline[i].id);
        return outline;
    }
    const auto add = [&](OutlineEdgeId outline_edge, Index from, Index to) {
        bound(outline.edges.emplace_back(OutlineEdge{from, to, {}, s.source_of(u, outline_edge)}), outline_edge);
    };
    outline.points = s.loop_points;
    for (const Loop& loop : s.loops) {
        const auto first = static_cast<Index>(loop.first), last = static_cast<Index>(loop.first + loop.count - 1);
        for (Index i = first; i < last; ++i) add(s.loop_edges[i], i, i + 1);
        Index end = first;
        if (!loop.closed) {
            end = static_cast<Index>(outline.points.size());
            outline.points.push_back(loop.end);
        }
        add(s.loop_edges[last], last, end);
    }
    return outline;
}

}  // namespace

PiecePlan plan_sides(const BySide<std::vector<ShellRoot>>& whole, CutScratch& s)
{
    PiecePlan plan;
    for (const Side side : kSides) {
        plan.whole_fragment[side].assign(whole[side].size(), 0);
        plan.fragment_count[side] = whole[side].empty() && s.targets.empty() ? 0 : 1;
    }
    // Piece shells come in pairs: negative, positive.
    std::unordered_map<std::uint32_t, Index> piece_shell_of_solid;
    for (Target& t : s.targets) {
        const CutShell& shell = s.cut_shells[t.shell];
        const auto [entry, is_new] =
            piece_shell_of_solid.try_emplace(shell.solid, static_cast<Index>(s.piece_shells.size()));
        if (is_new)
            for (const Side side : kSides) {
                PieceShell b;
                b.side = side;
                b.solid = shell.solid;
                b.shell = t.shell;
                // One curve on a connected shell leaves one part on each side, whatever the shell's genus.
                b.connected = shell.connected && shell.loops == 1 && s.loops_are_all_curves();
                s.piece_shells.push_back(b);
            }
        t.piece_shell = entry->second + static_cast<Index>(t.side);
        // Whether caps connect several shells of a solid is not looked into.
        PieceShell& b = s.piece_shells[t.piece_shell];
        b.connected = b.connected && b.shell == t.shell;
    }
    return plan;
}

PiecePlan plan_pieces(const Universe& universe, const Plane& plane, const BySide<std::vector<ShellRoot>>& whole,
                      CutScratch& s)
{
    BySide<PartsOfSide> sides{PartsOfSide(universe, plane, Side::negative, whole[Side::negative], s),
                              PartsOfSide(universe, plane, Side::positive, whole[Side::positive], s)};
    DisjointSets same(static_cast<std::uint32_t>(s.targets.size()));
    if (s.irregular && s.targets.size() > 2 * s.cut_shells.size())
        for (const auto& [a, b] : targets_that_share_edges(universe, s)) same.unite(a, b);
    if (s.irregular && universe.has_boundary) find_edges_that_bound_nothing(universe, s);
    for (PartsOfSide& side : sides) side.list(same);
    const PiecesOutline outline = outline_of(universe, s, sides);
    for (PartsOfSide& side : sides) side.measure();

    BySide<SideParts> input;
    for (const Side side : kSides)
        input[side] = {sides[side].parts(),
                       [&parts = sides[side]](std::span<const AxisRay> rays, const std::vector<bool>& is_wanted,
                                              const AddCrossing& add) { parts.count_crossings(rays, is_wanted, add); }};
    const BySide<std::vector<std::uint32_t>> piece = group_pieces(plane, input, outline.points, outline.edges);
    PiecePlan plan;
    for (const Side side : kSides)
        plan.fragment_count[side] = sides[side].make_piece_shells(piece[side], s, plan.whole_fragment[side]);
    if (s.irregular) relink_outline(universe, plane, s);
    return plan;
}

void plan_cap_sets(CutScratch& s)
{
    std::map<BySide<Index>, Index> sets;
    for (Loop& loop : s.loops)
        loop.cap_set = sets.try_emplace(s.piece_shells_of(s.loop_edges[loop.first]), Index(sets.size())).first->second;
}

void hand_out_caps(CutScratch& s)
{
    std::vector<BySide<Index>> piece_shells_of_set;
    for (const Loop& loop : s.loops) {
        if (loop.cap_set >= piece_shells_of_set.size()) piece_shells_of_set.resize(loop.cap_set + 1);
        piece_shells_of_set[loop.cap_set] = s.piece_shells_of(s.loop_edges[loop.first]);
    }
    s.cap_piece_shell.resize(s.caps.size());
    for (const CapSet& cap : s.cap_sets) {
        const BySide<Index> piece_shells = piece_shells_of_set[cap.set];
        for (std::size_t t = cap.first; t < cap.first + cap.count; ++t) s.cap_piece_shell[t] = piece_shells;
        for (const Index piece_shell : piece_shells)
            s.piece_shells[piece_shell].cap_count += static_cast<std::uint32_t>(cap.count);
    }
}

void divide_piece_shells(CutScratch& s)
{
    const auto targets = static_cast<std::uint32_t>(s.targets.size()), caps = static_cast<std::uint32_t>(s.caps.size());
    std::vector<std::uint32_t> targets_in(s.piece_shells.size(), 0);
    for (const Target& t : s.targets) ++targets_in[t.piece_shell];
    if (std::none_of(targets_in.begin(), targets_in.end(), [](std::uint32_t count) { return count > 1; })) return;

    // Targets, then the caps of either side.
    DisjointSets joined(targets + 2 * caps);
    const auto cap_number = [&](Side side, Index t) { return targets + static_cast<std::uint32_t>(side) * caps + t; };
    for (const Side side : kSides) {
        for (std::uint32_t t = 0; t < caps; ++t)
            for (const CapLink link : s.caps[t].link)
                joined.unite(cap_number(side, t), link.is_outline()
                                                      ? s.target_of(s.loop_edges[link.outline_edge()], side)
                                                      : cap_number(side, link.triangle()));
        for (const auto& [a, b] : s.cancelled) joined.unite(s.target_of(a, side), s.target_of(b, side));
    }
    // The first target of a piece shell keeps it together with all that is connected with it.
    std::vector<Index> first(s.piece_shells.size(), kNone), piece_shell_of_set(targets, kNone);
    for (Index t = 0; t < targets; ++t) {
        const Index set = joined.find(t), old = s.targets[t].piece_shell;
        if (first[old] == kNone) {
            first[old] = t;
            piece_shell_of_set[set] = old;
        }
        if (piece_shell_of_set[set] == kNone) {
            piece_shell_of_set[set] = static_cast<Index>(s.piece_shells.size());
            PieceShell b = s.piece_shells[old];
            b.cap_count = 0;
            s.piece_shells.push_back(b);
        }
        s.targets[t].piece_shell = piece_shell_of_set[set];
    }
    for (const Side side : kSides)
        for (std::uint32_t t = 0; t < caps; ++t) {
            Index& piece_shell = s.cap_piece_shell[t][side];
            --s.piece_shells[piece_shell].cap_count;
            piece_shell = piece_shell_of_set[joined.find(cap_number(side, t))];
            ++s.piece_shells[piece_shell].cap_count;
        }
}

}  // namespace kerf::halfedge
