#include "halfedge/piece_plan.h"

#include <algorithm>

#include "common/disjoint_sets.h"
#include "common/pieces.h"
#include "halfedge/export.h"

namespace kerf::halfedge {

namespace {

constexpr std::array kSides{Side::negative, Side::positive};

/// Signed crossings of a ray with a subtree; boxes that the ray misses are skipped.
int count_crossings(const Universe& u, Index root, const AxisRay& ray)
{
    const int v = (ray.axis + 1) % 3, w = (ray.axis + 2) % 3;
    const auto meets = [&](const Box& box) {
        return box.lo[v] <= ray.origin[v] && ray.origin[v] <= box.hi[v] && box.lo[w] <= ray.origin[w] &&
               ray.origin[w] <= box.hi[w] &&
               (ray.ascending ? box.hi[ray.axis] >= ray.origin[ray.axis] : box.lo[ray.axis] <= ray.origin[ray.axis]);
    };
    int count = 0;
    std::vector<Index> stack{root};
    while (!stack.empty()) {
        const Node& node = u.tree.nodes[stack.back()];
        stack.pop_back();
        if (!meets(node.box)) continue;
        if (!node.is_leaf()) {
            stack.push_back(node.left);
            stack.push_back(node.right);
            continue;
        }
        for (Index slot = node.first; slot < node.first + node.count; ++slot) {
            const Triangle& t = u.slots[slot];
            count += ray_crossing(ray, u.vertices[t[0]].position, u.vertices[t[1]].position, u.vertices[t[2]].position);
        }
    }
    return count;
}

/// Plans the pieces of one side.
class SidePieces
{
public:
    SidePieces(const Universe& universe, const Plane& plane, Side side, const std::vector<Shell>& whole,
               const Components& components, CutScratch& scratch)
        : u_(universe), plane_(plane), side_(side), whole_(whole), components_(components), s_(scratch)
    {
    }

    Index run(std::vector<Index>& whole_fragment)
    {
        list_parts();
        list_loops();
        const std::vector<std::uint32_t> piece =
            group_pieces(plane_, side_, parts_, loops_,
                         [&](std::uint32_t part, const AxisRay& ray) { return crossings_of_part(part, ray); });
        return number(piece, whole_fragment);
    }

private:
    std::size_t at() const { return static_cast<std::size_t>(side_); }

    void list_parts()
    {
        part_of_target_.assign(s_.targets.size(), kNone);
        for (Index t = 0; t < s_.targets.size(); ++t) {
            const Target& target = s_.targets[t];
            if (target.side != side_) continue;
            const CutShell& shell = s_.cut_shells[target.shell];
            SurfacePart part;
            part.solid = shell.solid;
            part.is_cut = shell.connected;
            part.sample = components_.loose()[t].sample;
            part.volume6 = components_.loose()[t].volume6;
            part_of_target_[t] = static_cast<Index>(parts_.size());
            targets_.push_back(t);
            parts_.push_back(part);
        }
        for (const Shell& shell : whole_) {
            SurfacePart part;
            part.solid = shell.solid;
            part.volume6 = u_.tree.moments[shell.root].volume6;
            Index n = shell.root;
            while (!u_.tree.nodes[n].is_leaf()) n = u_.tree.nodes[n].left;
            part.sample = u_.vertices[u_.slots[u_.tree.nodes[n].first][0]].position;
            parts_.push_back(part);
        }
    }

    void list_loops()
    {
        std::vector<Index> bounded;
        for (const Loop& loop : s_.loops) {
            bounded.clear();
            for (std::size_t i = loop.first; i < loop.first + loop.count; ++i) {
                const Index part = part_of_target_[s_.target_of_seam(s_.loop_seams[i], side_)];
                if (bounded.empty() || bounded.back() != part) bounded.push_back(part);
            }
            std::sort(bounded.begin(), bounded.end());
            bounded.erase(std::unique(bounded.begin(), bounded.end()), bounded.end());
            for (const Index part : bounded) {
                parts_[part].is_cut = true;
                if (loop.closed) loops_.push_back({part, {&s_.loop_points[loop.first], loop.count}});
            }
        }
    }

    int crossings_of_part(Index part, const AxisRay& ray) const
    {
        if (part >= targets_.size()) return count_crossings(u_, whole_[part - targets_.size()].root, ray);
        const Index target = targets_[part];
        const CutShell& shell = s_.cut_shells[s_.targets[target].shell];
        int count = 0;
        for (std::size_t i = shell.first_op; i < shell.first_op + shell.op_count; ++i) {
            const TreeOp& op = s_.ops[i];
            if (op.kind == TreeOp::Kind::whole && op.argument == target) {
                count += count_crossings(u_, op.node, ray);
            } else if (op.kind == TreeOp::Kind::leaf) {
                const Node& node = u_.tree.nodes[op.node];
                for (Index e = 0; e < node.count; ++e) {
                    // The ray runs away from the plane, so it meets a crossing triangle where this side's piece is.
                    const Index entry = s_.entries[op.argument + e];
                    const Index goes_to =
                        entry < kCrossingEntry ? entry : s_.crossings[entry - kCrossingEntry].target[at()];
                    if (goes_to != target) continue;
                    const Triangle& t = u_.slots[node.first + e];
                    count += ray_crossing(ray, u_.vertices[t[0]].position, u_.vertices[t[1]].position,
                                          u_.vertices[t[2]].position);
                }
            }
        }
        return count;
    }

    /// Caps may join what group_pieces() left apart (self-intersecting input); then numbers the pieces, makes bundles
    /// and hands out the caps.
    Index number(const std::vector<std::uint32_t>& piece, std::vector<Index>& whole_fragment)
    {
        std::uint32_t piece_count = 0;
        for (const std::uint32_t p : piece) piece_count = std::max(piece_count, p + 1);
        DisjointSets joined(piece_count);
        DisjointSets caps(static_cast<std::uint32_t>(s_.caps.size()));
        std::vector<Index> piece_of_cap(s_.caps.size(), kNone);
        for (Index t = 0; t < s_.caps.size(); ++t)
            for (const Index link : s_.caps[t].link)
                if ((link & kSeamLink) == 0) caps.unite(t, link / 3);
        for (Index t = 0; t < s_.caps.size(); ++t)
            for (const Index link : s_.caps[t].link) {
                if ((link & kSeamLink) == 0) continue;
                const Index target = s_.target_of_seam(s_.loop_seams[link - kSeamLink], side_);
                Index& known = piece_of_cap[caps.find(t)];
                if (known == kNone)
                    known = piece[part_of_target_[target]];
                else
                    joined.unite(known, piece[part_of_target_[target]]);
            }

        std::vector<Index> fragment(piece_count, kNone), bundle(piece_count, kNone), targets_in(piece_count, 0);
        Index fragments = 0;
        const auto fragment_of = [&](std::uint32_t p) {
            Index& number = fragment[joined.find(p)];
            if (number == kNone) number = fragments++;
            return number;
        };
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            const std::uint32_t p = joined.find(piece[i]);
            if (bundle[p] == kNone) {
                Bundle b;
                b.side = side_;
                b.solid = parts_[i].solid;
                b.fragment = fragment_of(p);
                bundle[p] = static_cast<Index>(s_.bundles.size());
                s_.bundles.push_back(b);
            }
            s_.targets[targets_[i]].bundle = bundle[p];
            ++targets_in[p];
        }
        whole_fragment.clear();
        for (std::size_t i = targets_.size(); i < piece.size(); ++i) whole_fragment.push_back(fragment_of(piece[i]));

        std::vector<Index> caps_in(piece_count, 0);
        for (Index t = 0; t < s_.caps.size(); ++t) {
            const Index known = piece_of_cap[caps.find(t)];
            const std::uint32_t p = joined.find(known == kNone ? 0 : known);
            if (caps.find(t) == t) ++caps_in[p];
            s_.cap_bundle[t][at()] = bundle[p];
            ++s_.bundles[bundle[p]].cap_count;
        }
        // Several parts hang together by edges if one connected cap joins them all.
        for (std::uint32_t p = 0; p < piece_count; ++p)
            if (bundle[p] != kNone) s_.bundles[bundle[p]].connected = targets_in[p] == 1 || caps_in[p] == 1;
        return fragments;
    }

    const Universe& u_;
    const Plane& plane_;
    const Side side_;
    const std::vector<Shell>& whole_;
    const Components& components_;
    CutScratch& s_;
    std::vector<SurfacePart> parts_;  // targets of this side, then whole shells
    std::vector<Index> targets_;      // of the first parts
    std::vector<Index> part_of_target_;
    std::vector<PartLoop> loops_;
};

}  // namespace

PiecePlan plan_sides(const std::array<std::vector<Shell>, 2>& whole, CutScratch& s)
{
    PiecePlan plan;
    for (const Side side : kSides) {
        const auto at = static_cast<std::size_t>(side);
        plan.whole_fragment[at].assign(whole[at].size(), 0);
        plan.fragment_count[at] = whole[at].empty() && s.targets.empty() ? 0 : 1;
    }
    // Bundles come in pairs: negative, positive.
    const auto bundle_of = [&](std::uint32_t solid) {
        Index bundle = 0;
        while (bundle < s.bundles.size() && s.bundles[bundle].solid != solid) bundle += 2;
        return bundle;
    };
    for (Target& t : s.targets) {
        const CutShell& shell = s.cut_shells[t.shell];
        const Index bundle = bundle_of(shell.solid);
        if (bundle == s.bundles.size())
            for (const Side side : kSides) {
                Bundle b;
                b.side = side;
                b.solid = shell.solid;
                b.shell = t.shell;
                // One curve on a connected shell leaves one part on each side, whatever the shell's genus.
                b.connected = shell.connected && shell.loops == 1;
                s.bundles.push_back(b);
            }
        t.bundle = bundle + static_cast<Index>(t.side);
        // Whether caps connect several shells of a solid is not looked into.
        Bundle& b = s.bundles[t.bundle];
        b.connected = b.connected && b.shell == t.shell;
    }
    for (const SolidCap& cap : s.solid_caps) {
        const Index bundle = bundle_of(cap.solid);
        for (std::size_t t = cap.first; t < cap.first + cap.count; ++t) s.cap_bundle[t] = {bundle, bundle + 1};
        for (Index i = bundle; i < bundle + 2; ++i) s.bundles[i].cap_count += static_cast<std::uint32_t>(cap.count);
    }
    return plan;
}

PiecePlan plan_pieces(const Universe& universe, const Plane& plane, const std::array<std::vector<Shell>, 2>& whole,
                      const Components& components, CutScratch& scratch)
{
    PiecePlan plan;
    for (const Side side : kSides) {
        const auto at = static_cast<std::size_t>(side);
        plan.fragment_count[at] =
            SidePieces(universe, plane, side, whole[at], components, scratch).run(plan.whole_fragment[at]);
    }
    return plan;
}

}  // namespace kerf::halfedge
