#include "halfedge/cut/find_parts.h"

#include <algorithm>

#include "halfedge/cut/crossing_numbers.h"
#include "halfedge/universe/export.h"

namespace kerf::core::halfedge {

namespace {

bool disjoint(const Box& a, const Box& b)
{
    return a.hi.x < b.lo.x || b.hi.x < a.lo.x || a.hi.y < b.lo.y || b.hi.y < a.lo.y || a.hi.z < b.lo.z ||
           b.hi.z < a.lo.z;
}

/// A cut point has fallen on the corner that is not on its edge: what the triangle has on the far side shrinks to two
/// edges, one with the section's edge on its back and one between two neighbours, which have a point in common.
bool is_pinched(const Crossing& c, Side side)
{
    if (side == c.split.lone_side) return false;
    const std::uint8_t n = c.split.next_code, p = c.split.previous_code;
    return n == c.previous() ? p != c.previous() : p == c.next() && n != c.next();
}

}  // namespace

void PartFinder::separate(Universe& universe, const Section& section, Found& found, Pieces& pieces)
{
    u_ = &universe;
    section_ = &section;
    found_ = &found;
    pieces_ = &pieces;
    crossing_mark_.assign(found.crossings.size(), {kNone, kNone});
    any_pinched_ = section.coincidences.collapsed &&
                   std::any_of(found.crossings.begin(), found.crossings.end(),
                               [](const Crossing& c) { return is_pinched(c, opposite(c.split.lone_side)); });
    in_plane_edges_.clear();
    for (const InPlaneEdge& e : found.in_plane) in_plane_edges_.insert(edge_of(e.negative_halfedge));
    for (auto& glued : glued_) glued.clear();
    for (const auto& [a, b] : section.cancelled)
        for (const Side side : kSides) {
            const FaceId f = found.face_of(a, side), g = found.face_of(b, side);
            glued_[side].emplace(f, g);
            glued_[side].emplace(g, f);
        }
    for (Index i = 0; i < found.shells.size(); ++i) {
        const CutShell& shell = found.shells[i];
        // One curve on a connected shell: nothing to search.
        if (shell.connected && section.loops_on_shell[i] <= 1 && section.loops_are_all_curves()) continue;
        search_shell(i);
    }
}

// ----- searching -----

void PartFinder::search_shell(Index shell)
{
    searches_.clear();
    met_.clear();
    // Stamps above those of the crossing triangles.
    mark_base_ = u_->stamp_base + found_->crossings.size() + stamps_used_;
    const CutShell& cut_shell = found_->shells[shell];
    // What the section cuts off has a triangle at the section, if only at a part of it that has shrunk away.
    const auto start_both = [&](FaceId negative_face, FaceId positive_face) {
        start(negative_face, Side::negative);
        start(positive_face, Side::positive);
    };
    for (std::size_t i = cut_shell.first_crossing; i < cut_shell.first_crossing + cut_shell.crossing_count; ++i)
        start_both(found_->crossings[i].face, found_->crossings[i].face);
    for (std::size_t i = cut_shell.first_in_plane; i < cut_shell.first_in_plane + cut_shell.in_plane_count; ++i)
        start_both(found_->in_plane[i].negative_face, found_->in_plane[i].positive_face);
    if (any_pinched_)
        for (std::size_t i = cut_shell.first_crossing; i < cut_shell.first_crossing + cut_shell.crossing_count; ++i) {
            // What lies beyond a pinched triangle need not be at the section elsewhere.
            const Crossing& c = found_->crossings[i];
            const Side far = opposite(c.split.lone_side);
            const FaceId beyond = u_->mesh.face(opposite(c.halfedge[static_cast<std::size_t>(c.next())]));
            if (is_pinched(c, far) && beyond.is_valid()) start(beyond, far);
        }
    if (!cut_shell.connected) seed_whole_shell(shell);

    for (const Side side : kSides) search_side(side, cut_shell.connected);
    assign_targets(shell);
    retarget(shell);
    for (const Search& search : searches_) found_->triangles_read += search.faces.size();
}

/// Searches that have something left take the same number of steps a round, until they all are one: the rest of a
/// connected shell is theirs.
void PartFinder::search_side(Side side, bool connected)
{
    std::vector<Index> active;
    for (Index i = 0; i < searches_.size(); ++i)
        if (searches_[i].side == side && !is_finished(i)) active.push_back(i);
    const auto are_one = [&] {
        return std::all_of(active.begin(), active.end(),
                           [&](Index i) { return met_.find(i) == met_.find(active.front()); });
    };
    while (!active.empty() && !(connected && are_one())) {
        for (const Index i : active) advance(i);
        std::erase_if(active, [&](Index i) { return is_finished(i); });
    }
}

Index PartFinder::crossing_of(FaceId face) const
{
    return stamped_number(*u_, face, found_->crossings.size());
}

bool PartFinder::keeps_something(FaceId face, Side side) const
{
    const Index crossing = crossing_of(face);
    if (crossing == kNone) return true;
    const TriangleSplit& split = found_->crossings[crossing].split;
    return std::ranges::any_of(split.sub_triangles(), [&](const SubTriangle& t) { return t.side == side; });
}

void PartFinder::start(FaceId face, Side side)
{
    const Index crossing = crossing_of(face);
    const std::uint64_t stamp = u_->stamp_of_face[face];
    const bool reached = crossing != kNone ? crossing_mark_[crossing][side] != kNone
                                           : stamp >= mark_base_ && stamp - mark_base_ < searches_.size();
    if (reached) return;
    Search search;
    search.side = side;
    searches_.push_back(std::move(search));
    met_.add();
    ++stamps_used_;  // before it is on any face: memory may run out half-way, and the next cut must know
    reach(face, static_cast<Index>(searches_.size() - 1));
    // Follow the section first: one search for each curve instead of one for each of its triangles.
    while (searches_.back().next < searches_.back().faces.size()) {
        const FaceId at = searches_.back().faces[searches_.back().next];
        ++searches_.back().next;
        for_each_neighbour(at, side, [&](FaceId neighbour) {
            if (crossing_of(neighbour) != kNone) reach(neighbour, static_cast<Index>(searches_.size() - 1));
        });
    }
    searches_.back().next = 0;
}

void PartFinder::reach(FaceId face, Index search)
{
    const Index crossing = crossing_of(face);
    const Side side = searches_[search].side;
    if (crossing != kNone) {
        Index& mark = crossing_mark_[crossing][side];
        if (mark != kNone) return met_.unite(mark, search);
        mark = search;
    } else {
        Index& stamp = u_->stamp_of_face[face];
        if (stamp >= mark_base_ && stamp - mark_base_ < searches_.size())
            return met_.unite(static_cast<Index>(stamp - mark_base_), search);
        stamp = static_cast<Index>(mark_base_ + search);
    }
    searches_[search].faces.push_back(face);
}

void PartFinder::advance(Index search)
{
    constexpr int kSteps = 16;
    for (int i = 0; i < kSteps && searches_[search].next < searches_[search].faces.size(); ++i) {
        const FaceId face = searches_[search].faces[searches_[search].next++];
        for_each_neighbour(face, searches_[search].side, [&](FaceId neighbour) { reach(neighbour, search); });
    }
}

/// The half-edge by which one that enters a face leaves it again, if the face is pinched and shrinks to both of them;
/// otherwise none.
HalfedgeId PartFinder::beyond_pinched(HalfedgeId halfedge, Side side) const
{
    const Index number = crossing_of(u_->mesh.face(halfedge));
    if (number == kNone || !is_pinched(found_->crossings[number], side)) return HalfedgeId();
    const Crossing& c = found_->crossings[number];
    const HalfedgeId between = c.halfedge[static_cast<std::size_t>(c.next())];
    const HalfedgeId crossed =
        c.halfedge[static_cast<std::size_t>(c.split.next_code == c.previous() ? c.lone() : c.previous())];
    if (halfedge == between) return crossed;
    return halfedge == crossed ? between : HalfedgeId();
}

template <class Visit>
void PartFinder::for_each_neighbour(FaceId face, Side side, Visit visit) const
{
    const auto across = [&](HalfedgeId h) {
        HalfedgeId entered;
        for (; h.is_valid(); h = any_pinched_ ? beyond_pinched(entered, side) : HalfedgeId()) {
            entered = opposite(h);
            if (u_->mesh.is_boundary(entered) || (!in_plane_edges_.empty() && in_plane_edges_.count(edge_of(h)) > 0))
                return;
        }
        visit(u_->mesh.face(entered));
    };
    const Index number = crossing_of(face);
    if (number == kNone) {
        HalfedgeId h = u_->mesh.halfedge_of(face);
        for (int i = 0; i < 3; ++i, h = u_->mesh.next(h)) across(h);
    } else {
        // Edges of which this side keeps something; sub-triangles that vanish conduct, too, because their rims are
        // glued.
        const Crossing& c = found_->crossings[number];
        const bool near = side == c.split.lone_side;
        const auto keeps = [&](CutPointId cut_point, bool end_is_lone) {
            return cut_point.is_valid() || end_is_lone != near;
        };
        const auto lone = static_cast<std::size_t>(c.lone()), next = static_cast<std::size_t>(c.next()),
                   previous = static_cast<std::size_t>(c.previous());
        if (any_pinched_ && is_pinched(c, side)) {
            // The edge that the section's edge lies on. The other one leads from neighbour to neighbour.
            across(c.halfedge[c.split.next_code == c.previous() ? previous : lone]);
        } else {
            if (keeps(c.n_cut_point(), c.split.next_code == c.lone())) across(c.halfedge[lone]);
            if (keeps(c.p_cut_point(), c.split.previous_code == c.lone())) across(c.halfedge[previous]);
            if (!near) across(c.halfedge[next]);
        }
    }
    const auto& glued = glued_[side];
    if (glued.empty()) return;
    const auto [first, last] = glued.equal_range(face);
    for (auto it = first; it != last; ++it) visit(it->second);
}

void PartFinder::seed_whole_shell(Index shell)
{
    const CutShell& cut_shell = found_->shells[shell];
    Index flooded = 0;
    for (std::size_t i = cut_shell.first_op; i < cut_shell.first_op + cut_shell.op_count; ++i) {
        const TreeOp op = found_->ops[i];
        if (op.kind == TreeOp::Kind::whole) {
            for_each_slot(*u_, op.node,
                          [&](SlotId slot) { start(u_->face_of_slot[slot], pieces_->target(op.target()).side); });
        } else if (op.kind == TreeOp::Kind::leaf) {
            const Node& node = u_->tree.nodes[op.node];
            for (Index e = 0; e < node.count; ++e) {
                const LeafEntry entry = found_->entries[op.argument + e];
                const FaceId face = u_->face_of_slot[node.first + e];
                if (entry.is_crossing()) {
                    start(face, Side::negative);
                    start(face, Side::positive);
                } else {
                    start(face, pieces_->target(entry.target()).side);
                }
            }
        }
        // Flood as we go, so that a search is started once for each part and not for each triangle.
        for (; flooded < searches_.size(); ++flooded)
            while (!is_finished(flooded)) advance(flooded);
    }
}

// ----- targets -----

void PartFinder::assign_targets(Index shell)
{
    for (const Side side : kSides) {
        // The largest part keeps the target: the one that is not finished, or else the one with the most faces.
        // Crossing triangles whose sub-triangles vanished count for nothing: a part of nothing else does not exist.
        Index largest = kNone;
        std::vector<std::size_t> size(searches_.size(), 0);
        std::vector<bool> unfinished(searches_.size(), false);
        for (Index i = 0; i < searches_.size(); ++i) {
            if (searches_[i].side != side) continue;
            const Index root = met_.find(i);
            const std::vector<FaceId>& faces = searches_[i].faces;
            size[root] += static_cast<std::size_t>(
                std::count_if(faces.begin(), faces.end(), [&](FaceId face) { return keeps_something(face, side); }));
            if (!is_finished(i)) unfinished[root] = true;
        }
        const auto better = [&](Index a, Index b) {
            if (unfinished[a] != unfinished[b]) return bool(unfinished[a]);
            return size[a] > size[b];
        };
        for (Index i = 0; i < searches_.size(); ++i)
            if (searches_[i].side == side && met_.find(i) == i && (largest == kNone || better(i, largest))) largest = i;
        const TargetId default_target = first_target(shell, side);
        if (largest != kNone) pieces_->target(default_target).is_empty = size[largest] == 0 && !unfinished[largest];

        Box& small = small_parts_[side];
        small = Box();
        for (Index i = 0; i < searches_.size(); ++i) {
            if (searches_[i].side != side) continue;
            Search& search = searches_[i];
            const Index root = met_.find(i);
            search.is_empty = size[root] == 0 && !unfinished[root];
            if (root != i) {
                search.target = searches_[root].target;
            } else if (i == largest || search.is_empty) {
                search.target = default_target;
            } else {
                Target t;
                t.side = side;
                t.shell = shell;
                search.target = pieces_->add(t);
            }
            if (search.target == default_target) continue;
            for (const FaceId face : search.faces) {
                HalfedgeId h = u_->mesh.halfedge_of(face);
                for (int corner = 0; corner < 3; ++corner, h = u_->mesh.next(h))
                    small.add(u_->mesh.position(u_->mesh.to(h)));
            }
        }
    }
}

TargetId PartFinder::target_of(FaceId face, Side side, Index shell) const
{
    const std::uint64_t stamp = u_->stamp_of_face[face];
    return stamp >= mark_base_ && stamp - mark_base_ < searches_.size()
               ? searches_[static_cast<Index>(stamp - mark_base_)].target
               : first_target(shell, side);
}

/// Rewrites what is known of single triangles and edges, then the program: subtrees that reach into the small parts are
/// opened.
void PartFinder::retarget(Index shell)
{
    CutShell& cut_shell = found_->shells[shell];
    for (std::size_t i = cut_shell.first_crossing; i < cut_shell.first_crossing + cut_shell.crossing_count; ++i)
        for (const Side side : kSides) {
            const Index search = crossing_mark_[i][side];
            if (search == kNone) continue;
            found_->crossings[i].target[side] = searches_[search].target;
            found_->crossings[i].bounds_nothing[side] = searches_[search].is_empty;
        }
    for (std::size_t i = cut_shell.first_flush; i < cut_shell.first_flush + cut_shell.flush_count; ++i)
        found_->flush[i].target = target_of(found_->flush[i].face, found_->flush[i].side, shell);
    for (std::size_t i = cut_shell.first_in_plane; i < cut_shell.first_in_plane + cut_shell.in_plane_count; ++i) {
        InPlaneEdge& e = found_->in_plane[i];
        e.target = {target_of(e.negative_face, Side::negative, shell),
                    target_of(e.positive_face, Side::positive, shell)};
    }

    ops_.assign(found_->ops.begin() + static_cast<std::ptrdiff_t>(cut_shell.first_op),
                found_->ops.begin() + static_cast<std::ptrdiff_t>(cut_shell.first_op + cut_shell.op_count));
    // The program moves to the end of the list.
    cut_shell.first_op = found_->ops.size();
    for (TreeOp& op : ops_) {
        if (op.kind == TreeOp::Kind::whole) {
            open_subtree(op.node, pieces_->target(op.target()).side, shell);
            continue;
        }
        if (op.kind == TreeOp::Kind::leaf) {
            const Node& node = u_->tree.nodes[op.node];
            const auto is_first = [&](TargetId target, Side side) { return target == first_target(shell, side); };
            for (Index e = 0; e < node.count; ++e) {
                LeafEntry& entry = found_->entries[op.argument + e];
                if (entry.is_crossing()) {
                    const BySide<TargetId>& target = found_->crossings[entry.crossing()].target;
                    for (const Side side : kSides) op.counts.sides_are_targets &= is_first(target[side], side);
                    continue;
                }
                const Side side = pieces_->target(entry.target()).side;
                entry = LeafEntry::to_target(target_of(u_->face_of_slot[node.first + e], side, shell));
                op.counts.sides_are_targets &= is_first(entry.target(), side);
            }
        }
        found_->ops.push_back(op);
    }
    cut_shell.op_count = found_->ops.size() - cut_shell.first_op;
}

/// Appends the program of a subtree that is kept on a side: as few nodes as keep the parts of that side apart.
void PartFinder::open_subtree(NodeId root, Side side, Index shell)
{
    stack_.assign(1, {root, false});
    while (!stack_.empty()) {
        const auto [n, children_done] = stack_.back();
        stack_.pop_back();
        if (children_done) {
            found_->ops.push_back({TreeOp::Kind::join, n, kNone});
            continue;
        }
        const Node& node = u_->tree.nodes[n];
        if (disjoint(node.box, small_parts_[side])) {
            found_->ops.push_back(TreeOp::hand_over(n, first_target(shell, side)));
            continue;
        }
        ++found_->nodes_visited;
        if (!node.is_leaf()) {
            stack_.push_back({n, true});
            stack_.push_back({node.right, false});
            stack_.push_back({node.left, false});
            continue;
        }
        const Index first_entry = static_cast<Index>(found_->entries.size());
        bool uniform = true;
        for (Index e = 0; e < node.count; ++e) {
            found_->entries.push_back(LeafEntry::to_target(target_of(u_->face_of_slot[node.first + e], side, shell)));
            uniform = uniform && found_->entries.back() == found_->entries[first_entry];
        }
        if (uniform) {
            found_->ops.push_back(TreeOp::hand_over(n, found_->entries[first_entry].target()));
            found_->entries.resize(first_entry);
            found_->triangles_read += node.count;
        } else {
            found_->ops.push_back({TreeOp::Kind::leaf, n, first_entry});
        }
    }
}

}  // namespace kerf::core::halfedge
