#include "halfedge/universe/compaction.h"

#include <algorithm>
#include <unordered_map>

#include "halfedge/universe/export.h"

namespace kerf::halfedge {

namespace {

/// New numbers for old ones, in the order in which they are asked for. A table, or a hash table where few of many are.
class Renumbering
{
public:
    Renumbering(std::size_t old_count, std::size_t expected) : sparse_(expected < old_count / 16)
    {
        if (sparse_)
            map_.reserve(expected);
        else
            table_.assign(old_count, kNone);
        old_.reserve(expected);
    }

    Index operator()(Index old)
    {
        Index& number = sparse_ ? map_.try_emplace(old, kNone).first->second : table_[old];
        if (number == kNone) {
            number = static_cast<Index>(old_.size());
            old_.push_back(old);
        }
        return number;
    }

    const std::vector<Index>& old() const { return old_; }
    std::size_t size() const { return old_.size(); }

private:
    bool sparse_;
    std::vector<Index> table_, old_;
    std::unordered_map<Index, Index> map_;
};

/// Slots of one shell and group that follow one another in the tree's order.
struct Segment
{
    Index group, shell;
    std::span<const TriangleTree::Run> runs;
    std::uint32_t count = 0;  ///< triangles
    Index root = kNone;       ///< of the copy
};

/// The segments of some shells, in the tree's order.
class Segments
{
public:
    Segments(const Universe& u, std::span<const ShellRoot> shells)
    {
        std::vector<std::size_t> first_run;
        std::vector<TriangleTree::Run> runs_of_shell;
        for (Index s = 0; s < shells.size(); ++s) {
            runs_of_shell.clear();
            u.tree.append_runs(shells[s].root, runs_of_shell);
            for (const TriangleTree::Run& run : runs_of_shell) {
                if (list_.empty() || list_.back().shell != s || list_.back().group != run.group) {
                    first_run.push_back(runs_.size());
                    list_.push_back({run.group, s, {}, 0, kNone});
                }
                list_.back().count += run.count;
                runs_.push_back(run);
            }
        }
        first_run.push_back(runs_.size());
        for (std::size_t i = 0; i < list_.size(); ++i)
            list_[i].runs = std::span(runs_).subspan(first_run[i], first_run[i + 1] - first_run[i]);
    }

    std::vector<Segment>& list() { return list_; }

private:
    std::vector<TriangleTree::Run> runs_;
    std::vector<Segment> list_;
};

/// Those of one group lie side by side, groups as they are drawn.
std::vector<Segment*> in_drawing_order(const Universe& u, std::vector<Segment>& segments)
{
    std::vector<Segment*> order;
    order.reserve(segments.size());
    for (Segment& segment : segments) order.push_back(&segment);
    std::stable_sort(order.begin(), order.end(), [&](const Segment* a, const Segment* b) {
        return a->group != b->group && draws_before(u.groups[a->group], u.groups[b->group]);
    });
    return order;
}

/// The balanced tree over segments of one shell, in their order.
Index join_all(TriangleTree& tree, std::span<const Segment> segments)
{
    if (segments.empty()) return kNone;
    if (segments.size() == 1) return segments.front().root;
    const std::size_t half = segments.size() / 2;
    const Index left = join_all(tree, segments.first(half));
    return tree.join(left, join_all(tree, segments.subspan(half)));
}

}  // namespace

std::vector<ShellRoot> compact_copy(const Universe& u, std::span<const ShellRoot> shells, Universe& v)
{
    std::vector<ShellRoot> copies(shells.begin(), shells.end());
    v.groups = u.groups;
    v.materials = u.materials;
    v.cap_material = u.cap_material;
    v.reference = u.reference;
    v.noise = u.noise;
    v.has_boundary = u.has_boundary;

    Segments segments(u, shells);
    const std::vector<Segment*> order = in_drawing_order(u, segments.list());
    std::size_t n = 0, nodes = 0;
    for (const Segment& segment : segments.list()) {
        n += segment.count;
        nodes += TriangleTree::nodes_for_run(segment.count) + 1;
    }
    Renumbering vertices(u.vertices.size(), n), points(u.mesh.vertices(), n), edges(u.mesh.edges(), 2 * n);
    std::vector<Index> old_face;
    old_face.reserve(n);
    const std::size_t crossings = reserved_crossings(n);
    v.slots.reserve(n + 18 * crossings);
    for (const Segment* segment : order)
        for (const TriangleTree::Run& run : segment->runs)
            for (Index slot = run.first; slot < run.first + run.count; ++slot) {
                const Index face = u.face_of_slot[slot];
                Triangle triangle;
                Index h = u.mesh.halfedge_of_face(face);
                for (std::size_t c = 0; c < 3; ++c, h = u.mesh.next(h)) {
                    triangle[c] = vertices(u.slots[slot][c]);
                    static_cast<void>(points(u.mesh.from(h)));
                    static_cast<void>(edges(h / 2));
                }
                v.slots.push(triangle);
                old_face.push_back(face);
            }

    v.mesh.reserve(points.size() + 2 * crossings, edges.size() + 6 * crossings, n + 4 * crossings);
    v.mesh.resize(points.size(), edges.size(), n);
    const auto new_halfedge = [&](Index h) { return 2 * edges(h / 2) + (h & 1u); };
    for (Index f = 0; f < n; ++f) {
        std::array<Index, 3> h;
        h[0] = u.mesh.halfedge_of_face(old_face[f]);
        h[1] = u.mesh.next(h[0]);
        h[2] = u.mesh.next(h[1]);
        v.mesh.set_triangle(f, new_halfedge(h[0]), new_halfedge(h[1]), new_halfedge(h[2]));
        for (const Index old : h) {
            v.mesh.set_to(new_halfedge(old), points(u.mesh.to(old)));
            if (!u.mesh.is_boundary(old ^ 1u)) continue;
            v.mesh.set_to(new_halfedge(old ^ 1u), points(u.mesh.to(old ^ 1u)));
            v.mesh.link(new_halfedge(old ^ 1u), new_halfedge(u.mesh.next(old ^ 1u)));
        }
    }
    for (Index p = 0; p < points.size(); ++p) {
        v.mesh.set_halfedge_of_vertex(p, new_halfedge(u.mesh.halfedge_of_vertex(points.old()[p])));
        v.mesh.set_point(p, u.mesh.point(points.old()[p]));
    }

    v.vertices.reserve(vertices.size() + 3 * crossings);
    for (const Index old : vertices.old()) v.vertices.push(u.vertices[old]);
    for (const Stream& stream : u.streams) {
        Stream& to = v.streams.emplace_back();
        to.name = stream.name;
        to.width = stream.width;
        to.values.reserve((vertices.size() + 3 * crossings) * stream.width);
        for (const Index old : vertices.old())
            for (std::size_t i = 0; i < stream.width; ++i)
                to.values.push(stream.values[std::size_t(old) * stream.width + i]);
    }
    v.face_of_slot.reserve(n + 18 * crossings);
    v.source_of_face.reserve(n + 4 * crossings);
    v.stamp_of_face.reserve(n + 4 * crossings);
    v.stamp_of_face.set_size(n);
    std::fill(v.stamp_of_face.begin(), v.stamp_of_face.end(), Index(0));
    for (Index f = 0; f < n; ++f) {
        v.face_of_slot.push(f);
        v.source_of_face.push(u.source_of_face[old_face[f]]);
    }

    v.tree.reserve(nodes + crossings + crossings / 4 + 64);
    std::uint32_t first = 0;
    for (Segment* segment : order) {
        segment->root = v.tree.make_run(v.geometry(), first, segment->count, segment->group);
        first += segment->count;
    }
    const std::span<const Segment> list = segments.list();
    for (std::size_t begin = 0, end; begin < list.size(); begin = end) {
        end = begin;
        while (end < list.size() && list[end].shell == list[begin].shell) ++end;
        copies[list[begin].shell].root = join_all(v.tree, list.subspan(begin, end - begin));
    }
    reserve_for_cuts(v, crossings);
    return copies;
}

}  // namespace kerf::halfedge
