#include "halfedge/cut/rebuild.h"

#include <algorithm>

#include "common/mesh/plane_frame.h"
#include "halfedge/cut/leaf_prefetch.h"

namespace kerf::core::halfedge {

namespace {

std::size_t end_of_entries(const Universe& u, const TreeOp& op)
{
    return op.argument + u.tree.nodes[op.node].count;
}

/// At most so many nodes are made for a target's part of a leaf: its own, and the one that joins it.
std::size_t nodes_for_part(std::uint32_t count)
{
    return count == 0 ? 0 : 1 + (count <= kMaxLeafTriangles ? 1 : TriangleTree::nodes_of_full_leaves(count));
}

/// The leaves of a program that are rewritten, one after another.
class LeavesToCome
{
public:
    explicit LeavesToCome(std::span<const TreeOp> ops) : ops_(ops) {}

    /// The next one, or none.
    NodeId next()
    {
        while (next_ < ops_.size() && ops_[next_].kind != TreeOp::Kind::leaf) ++next_;
        return next_ < ops_.size() ? ops_[next_++].node : NodeId();
    }

private:
    std::span<const TreeOp> ops_;
    std::size_t next_ = 0;
};

}  // namespace

/// Asks for what leaves to come consist of while others are rewritten: from FIND to here it has left the caches.
class Rebuilder::Ahead
{
public:
    Ahead(const Universe& universe, std::span<const TreeOp> ops)
        : u_(universe),
          for_triangles_(universe.geometry().is_far_away() ? ops : std::span<const TreeOp>()),
          for_vertices_(for_triangles_),
          triangles_(universe),
          vertices_(universe)
    {
        for (int i = 0; i < kTriangles; ++i) for_triangles_.next();
        for (int i = 0; i < kVertices; ++i) for_vertices_.next();
    }

    /// Before each leaf.
    void next()
    {
        aim(triangles_, for_triangles_.next());
        aim(vertices_, for_vertices_.next());
    }

    /// At each of its triangles.
    void step(Index i) const
    {
        triangles_.step(i);
        vertices_.step(i);
    }

private:
    static constexpr int kTriangles = 4, kVertices = 2;  // leaves ahead

    template <class Prefetch>
    void aim(Prefetch& prefetch, NodeId leaf) const
    {
        if (leaf.is_valid())
            prefetch.aim_at(u_.tree.nodes[leaf]);
        else
            prefetch.aim_at_none();
    }

    const Universe& u_;
    LeavesToCome for_triangles_, for_vertices_;
    TrianglePrefetch triangles_;
    VertexPrefetch vertices_;
};

std::size_t Rebuilder::plan(Universe& u, const Found& found, const Section& section, const Caps& caps, Pieces& pieces)
{
    part_.assign(pieces.targets.size(), LeafPart());
    part_nodes_ = 0;
    start_.assign(pieces.targets.size(), SlotId());
    std::size_t whole = 0;
    for (Index s = 0; s < found.shells.size(); ++s) {
        const CutShell& shell = found.shells[s];
        std::size_t crossing = shell.first_crossing;
        for (std::size_t i = shell.first_op; i < shell.first_op + shell.op_count; ++i) {
            const TreeOp& op = found.ops[i];
            whole += op.kind == TreeOp::Kind::whole;
            if (op.kind != TreeOp::Kind::leaf) continue;
            if (op.counts.sides_are_targets)
                count_sides(op.counts, s, crossing, found, pieces);
            else
                count_targets(u, op, static_cast<Index>(i), found, pieces);
            crossing += op.counts.crossing;
        }
    }

    for (const LeafPart& part : part_) part_nodes_ += nodes_for_part(part.count);

    // Negative side first, caps behind the surface of their side.
    const SlotId first_slot(static_cast<Index>(u.slots.size()));
    SlotId slot = first_slot;
    std::size_t nodes = part_nodes_ + whole + pieces.targets.size();
    for (const Side side : {Side::negative, Side::positive}) {
        for (Target& t : pieces.targets) {
            if (t.side != side) continue;
            t.cursor = slot;
            slot = slot + t.count;
        }
        for (PieceShell& piece_shell : pieces.shells) {
            if (piece_shell.side != side) continue;
            piece_shell.cap_first = piece_shell.cap_cursor = slot;
            slot = slot + piece_shell.cap_count;
            nodes += TriangleTree::nodes_of_full_leaves(piece_shell.cap_count) + 1;
        }
    }
    new_slots_ = slot - first_slot;
    new_vertices_ = section.new_vertices + (caps.triangles.empty() ? 0 : 2 * section.loop_points.size());

    results_.clear();
    results_.reserve(2 * whole + 4 * found.entries.size() + 16);
    lengths_.clear();
    lengths_.reserve(found.ops.size() + 2);
    touched_.reserve(pieces.targets.size() + 2);

    const std::size_t faces = 2 * found.crossings.size() + 2 * caps.triangles.size();
    std::size_t grown = u.vertices.make_room(new_vertices_) + u.slots.make_room(new_slots_) +
                        u.face_of_slot.make_room(new_slots_) + u.source_of_face.make_room(faces) +
                        u.stamp_of_face.make_room(faces) + u.tree.make_room(nodes);
    for (Stream& stream : u.streams) grown += stream.values.make_room(new_vertices_ * stream.width);
    return grown;
}

void Rebuilder::count_sides(const LeafCounts& counts, Index shell, std::size_t first_crossing, const Found& found,
                            Pieces& pieces)
{
    BySide<std::uint32_t> triangles{counts.kept[Side::negative], counts.kept[Side::positive]};
    for (std::size_t c = first_crossing; c < first_crossing + counts.crossing; ++c)
        for (const SubTriangle& t : found.crossings[c].split.sub_triangles()) ++triangles[t.side];
    for (const Side side : kSides) {
        part_nodes_ += nodes_for_part(triangles[side]);
        pieces.target(first_target(shell, side)).count += triangles[side];
    }
}

void Rebuilder::count_targets(const Universe& u, const TreeOp& op, Index number, const Found& found, Pieces& pieces)
{
    const auto count = [&](TargetId id) {
        LeafPart& part = part_[id.number()];
        if (part.leaf != number) {
            part_nodes_ += nodes_for_part(part.count);
            part = {number, 0};
        }
        ++part.count;
        ++pieces.target(id).count;
    };
    for (std::size_t e = op.argument; e < end_of_entries(u, op); ++e) {
        if (!found.entries[e].is_crossing()) {
            count(found.entries[e].target());
            continue;
        }
        const Crossing& c = found.crossings[found.entries[e].crossing()];
        for (const SubTriangle& t : c.split.sub_triangles()) count(c.target[t.side]);
    }
}

void Rebuilder::run(Universe& u, std::uint64_t triangles, const Plane& plane, const PlaneFrame& frame,
                    const StitchPlan& numbers, const Found& found, const Section& section, const Caps& caps,
                    Pieces& pieces)
{
    triangles_ = triangles;
    // Positions of the new vertices are behind the end already.
    cap_vertices_ = VertexId(static_cast<Index>(u.vertices.size() + section.new_vertices));
    if (!caps.triangles.empty()) write_cap_vertices(u, plane, frame, found, section);
    u.vertices.extend(new_vertices_);
    for (Stream& stream : u.streams) stream.values.extend(new_vertices_ * stream.width);

    const std::size_t faces = 2 * found.crossings.size() + 2 * caps.triangles.size();
    u.stamp_of_face.extend(faces);
    u.source_of_face.extend(faces);
    for (Index c = 0; c < found.crossings.size(); ++c) {
        const Index source = u.source_of_face[found.crossings[c].face];
        for (const FaceId face : numbers.new_faces(c)) u.source_of_face[face] = source;
    }

    u.slots.extend(new_slots_);
    u.face_of_slot.extend(new_slots_);
    first_fresh_node_ = NodeId(static_cast<Index>(u.tree.nodes.size()));
    for (Index s = 0; s < found.shells.size(); ++s) {
        const CutShell& shell = found.shells[s];
        results_.clear();
        lengths_.clear();
        Ahead ahead(u, std::span(found.ops).subspan(shell.first_op, shell.op_count));
        for (std::size_t i = shell.first_op; i < shell.first_op + shell.op_count; ++i) {
            constexpr std::size_t kAhead = 12;
            if (i + kAhead < shell.first_op + shell.op_count && found.ops[i + kAhead].kind == TreeOp::Kind::whole)
                u.tree.prefetch(found.ops[i + kAhead].node);
            const TreeOp& op = found.ops[i];
            switch (op.kind) {
                case TreeOp::Kind::whole:
                    results_.push_back({op.target(), op.node});
                    lengths_.push_back(1);
                    break;
                case TreeOp::Kind::leaf:
                    ahead.next();
                    if (op.counts.sides_are_targets)
                        rewrite_sides(u, op, s, ahead, numbers, found, pieces);
                    else
                        rewrite_targets(u, op, ahead, numbers, found, pieces);
                    break;
                case TreeOp::Kind::join:
                    join_results(u);
                    // A subtree that went to one side as a whole after all is still the old node.
                    if (lengths_.back() == 1) {
                        const Node& old = u.tree.nodes[op.node];
                        const Node& made = u.tree.nodes[results_.back().node];
                        if (made.left == old.left && made.right == old.right) results_.back().node = op.node;
                    }
                    break;
            }
        }
        for (const Result& result : results_) pieces.target(result.target).root = result.node;
    }
    for (const Target& t : pieces.targets)
        pieces.shells[t.piece_shell].root = u.tree.join(pieces.shells[t.piece_shell].root, t.root);
    write_caps(u, numbers, section.loop_points.size(), caps, pieces);
}

void Rebuilder::write_cap_vertices(Universe& u, const Plane& plane, const PlaneFrame& frame, const Found& found,
                                   const Section& section)
{
    const glm::vec3 normal(plane.normal);
    const Index points = static_cast<Index>(section.loop_points.size());
    for (Index i = 0; i < points; ++i) {
        const glm::vec3& p = section.loop_points[i];
        const glm::vec2 uv = frame.uv(p);
        u.vertices.data()[(cap_vertices_ + i).number()] = {p, normal, uv};
        u.vertices.data()[(cap_vertices_ + (points + i)).number()] = {p, -normal, uv};
    }
    for (Stream& stream : u.streams)
        for (Index i = 0; i < points; ++i) {
            // What the surface has where the outline edge starts.
            const OutlineEdgeId outline_edge = section.loop_edges[i];
            VertexId from;
            if (found.is_crossing(outline_edge)) {
                const Crossing& c = found.crossing(outline_edge);
                const std::uint8_t code = c.split.section_from;
                from = code == TriangleSplit::kCutNext       ? c.n_vertex()
                       : code == TriangleSplit::kCutPrevious ? c.p_vertex()
                                                             : c.corner[code];
            } else {
                from = found.in_plane_edge(outline_edge).start_vertex;
            }
            const float* values = stream.values.data() + std::size_t(from.number()) * stream.width;
            for (const VertexId copy : {cap_vertices_ + i, cap_vertices_ + (points + i)})
                std::copy_n(values, stream.width, stream.values.data() + std::size_t(copy.number()) * stream.width);
        }
}

namespace {

/// What of a crossing triangle exists, as the index buffer has it: calls visit(side, triangle, face).
template <class Visit>
void for_each_sub_triangle(const StitchPlan& numbers, const Crossing& c, Index number, Visit visit)
{
    const auto vertex = [&](std::uint8_t code) {
        if (code == TriangleSplit::kCutNext) return c.n_vertex().number();
        if (code == TriangleSplit::kCutPrevious) return c.p_vertex().number();
        return c.corner[code].number();
    };
    for (const SubFace& sub : numbers.sub_faces(c, number))
        if (sub.exists)
            visit(sub.side, Triangle{vertex(sub.corners[0]), vertex(sub.corners[1]), vertex(sub.corners[2])}, sub.face);
}

}  // namespace

void Rebuilder::rewrite_sides(Universe& u, const TreeOp& op, Index shell, const Ahead& ahead, const StitchPlan& numbers,
                              const Found& found, Pieces& pieces)
{
    const Node leaf = u.tree.nodes[op.node];
    const LeafEntry* const entries = &found.entries[op.argument];
    const Triangle* const old_triangles = &u.slots[leaf.first];
    const FaceId* const old_faces = &u.face_of_slot[leaf.first];
    const BySide<SlotId> first{pieces.target(first_target(shell, Side::negative)).cursor,
                               pieces.target(first_target(shell, Side::positive)).cursor};
    const BySide<Triangle*> triangles{&u.slots[first[Side::negative]], &u.slots[first[Side::positive]]};
    const BySide<FaceId*> faces{&u.face_of_slot[first[Side::negative]], &u.face_of_slot[first[Side::positive]]};
    BySide<std::uint32_t> count{};
    const auto emit = [&](Side side, const Triangle& triangle, FaceId face) {
        triangles[side][count[side]] = triangle;
        faces[side][count[side]] = face;
        ++count[side];
    };
    for (Index i = 0; i < leaf.count; ++i) {
        ahead.step(i);
        const LeafEntry entry = entries[i];
        if (!entry.is_crossing())
            emit(side_of_target(entry.target()), old_triangles[i], old_faces[i]);
        else
            for_each_sub_triangle(numbers, found.crossings[entry.crossing()], entry.crossing(), emit);
    }
    std::uint32_t parts = 0;
    for (const Side side : kSides) {
        if (count[side] == 0) continue;
        const TargetId target = first_target(shell, side);
        pieces.target(target).cursor = first[side] + count[side];
        results_.push_back({target, make_part(u, first[side], count[side], leaf.group)});
        ++parts;
    }
    lengths_.push_back(parts);
}

void Rebuilder::rewrite_targets(Universe& u, const TreeOp& op, const Ahead& ahead, const StitchPlan& numbers,
                                const Found& found, Pieces& pieces)
{
    const Node leaf = u.tree.nodes[op.node];
    touched_.clear();
    const auto emit = [&](TargetId target, const Triangle& triangle, FaceId face) {
        Target& t = pieces.target(target);
        if (!start_[target.number()].is_valid()) {
            start_[target.number()] = t.cursor;
            touched_.push_back(target);
        }
        u.slots[t.cursor] = triangle;
        u.face_of_slot[t.cursor] = face;
        ++t.cursor;
    };
    for (Index i = 0; i < leaf.count; ++i) {
        ahead.step(i);
        const LeafEntry entry = found.entries[op.argument + i];
        if (!entry.is_crossing()) {
            emit(entry.target(), u.slots[leaf.first + i], u.face_of_slot[leaf.first + i]);
            continue;
        }
        const Crossing& c = found.crossings[entry.crossing()];
        for_each_sub_triangle(numbers, c, entry.crossing(), [&](Side side, const Triangle& triangle, FaceId face) {
            emit(c.target[side], triangle, face);
        });
    }
    std::sort(touched_.begin(), touched_.end());
    for (const TargetId target : touched_) {
        const SlotId first = start_[target.number()];
        start_[target.number()] = SlotId();
        results_.push_back({target, make_part(u, first, pieces.target(target).cursor - first, leaf.group)});
    }
    lengths_.push_back(static_cast<std::uint32_t>(touched_.size()));
}

NodeId Rebuilder::make_part(Universe& u, SlotId first, std::uint32_t count, GroupId group) const
{
    return count <= kMaxLeafTriangles ? u.tree.make_leaf(u.geometry(triangles_), first, count, group)
                                      : u.tree.make_run(u.geometry(triangles_), first, count, group);
}

void Rebuilder::join_results(Universe& u)
{
    const std::uint32_t right_count = lengths_.back(), left_count = lengths_[lengths_.size() - 2];
    lengths_.pop_back();
    const auto combine = [&](NodeId left, NodeId right) {
        const Node &l = u.tree.nodes[left], &r = u.tree.nodes[right];
        if (left >= first_fresh_node_ && right >= first_fresh_node_ && l.is_leaf() && r.is_leaf() &&
            l.group == r.group && l.first + l.count == r.first && l.count + r.count <= kMaxLeafTriangles)
            return u.tree.merge_leaves(left, right);
        return u.tree.join(left, right);
    };
    const std::size_t end = results_.size(), middle = end - right_count, begin = middle - left_count;
    // The merged list is built behind the two and moved down.
    std::size_t l = begin, r = middle;
    while (l < middle || r < end) {
        if (r == end || (l < middle && results_[l].target < results_[r].target))
            results_.push_back(results_[l++]);
        else if (l == middle || results_[r].target < results_[l].target)
            results_.push_back(results_[r++]);
        else {
            const Result joined{results_[l].target, combine(results_[l].node, results_[r].node)};
            results_.push_back(joined);
            ++l;
            ++r;
        }
    }
    const std::size_t merged = results_.size() - end;
    std::copy(results_.begin() + static_cast<std::ptrdiff_t>(end), results_.end(),
              results_.begin() + static_cast<std::ptrdiff_t>(begin));
    results_.resize(begin + merged);
    lengths_.back() = static_cast<std::uint32_t>(merged);
}

void Rebuilder::write_caps(Universe& u, const StitchPlan& numbers, std::size_t points, const Caps& caps, Pieces& pieces)
{
    const Index negative_vertices = cap_vertices_.number(),
                positive_vertices = negative_vertices + static_cast<Index>(points);
    for (const Index t : caps.order) {
        const CapTriangle& cap = caps.triangles[t];
        for (const Side side : {Side::negative, Side::positive}) {
            PieceShell& piece_shell = pieces.shells[caps.piece_shells[t][side]];
            const SlotId slot = piece_shell.cap_cursor++;
            u.slots[slot] = side == Side::negative
                                ? Triangle{negative_vertices + cap.corner[0], negative_vertices + cap.corner[1],
                                           negative_vertices + cap.corner[2]}
                                : Triangle{positive_vertices + cap.corner[0], positive_vertices + cap.corner[2],
                                           positive_vertices + cap.corner[1]};
            u.face_of_slot[slot] = numbers.cap_face(side, t);
            u.source_of_face[numbers.cap_face(side, t)] = kNoSource;
        }
    }
    for (PieceShell& piece_shell : pieces.shells)
        piece_shell.root = u.tree.join(piece_shell.root, u.tree.make_run(u.geometry(triangles_), piece_shell.cap_first,
                                                                         piece_shell.cap_count, piece_shell.cap_group));
}

}  // namespace kerf::core::halfedge
