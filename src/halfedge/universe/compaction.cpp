#include "halfedge/universe/compaction.h"

#include <algorithm>

#include "halfedge/universe/cut_reserve.h"
#include "halfedge/universe/export.h"
#include "halfedge/universe/number_table.h"

namespace kerf::core::halfedge {

namespace {

/// New numbers for old ones, in the order of first request.
class Renumbering
{
public:
    Renumbering(std::size_t old_count, std::size_t expected) : numbers_(old_count, expected) { old_.reserve(expected); }

    Index operator()(Index old)
    {
        Index& number = numbers_(old);
        if (number == kNone) {
            number = static_cast<Index>(old_.size());
            old_.push_back(old);
        }
        return number;
    }

    const std::vector<Index>& old() const { return old_; }
    std::size_t size() const { return old_.size(); }

private:
    NumberTable numbers_;
    std::vector<Index> old_;
};

/// Slots of one shell and group that follow one another in the tree's order.
struct Segment
{
    GroupId group;
    Index shell;
    std::span<const TriangleTree::Run> runs;
    std::uint32_t count = 0;  ///< triangles
    NodeId root;              ///< of the copy
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
                    list_.push_back({run.group, s, {}, 0, {}});
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

/// Segments in drawing order: those of one group lie side by side.
std::vector<Segment*> in_drawing_order(const Universe& u, std::vector<Segment>& segments)
{
    std::vector<Segment*> order;
    order.reserve(segments.size());
    for (Segment& segment : segments) order.push_back(&segment);
    std::stable_sort(order.begin(), order.end(), [&](const Segment* a, const Segment* b) {
        return a->group != b->group && draws_before(u.group(a->group), u.group(b->group));
    });
    return order;
}

/// The balanced tree over segments of one shell, in their order.
NodeId join_all(TriangleTree& tree, std::span<const Segment> segments)
{
    if (segments.empty()) return {};
    if (segments.size() == 1) return segments.front().root;
    const std::size_t half = segments.size() / 2;
    const NodeId left = join_all(tree, segments.first(half));
    return tree.join(left, join_all(tree, segments.subspan(half)));
}

/// New numbers of the elements that the copy's triangles use, in the order in which export_mesh() visits them.
struct Copied
{
    Renumbering vertices, points, edges;
    std::vector<FaceId> old_face;

    Copied(const Universe& u, std::size_t triangles)
        : vertices(u.vertices.size(), triangles),
          points(u.mesh.points(), triangles),
          edges(u.mesh.edges(), 2 * triangles)
    {
        old_face.reserve(triangles);
    }
    PointId point(PointId old) { return PointId(int(points(number_of(old)))); }
    EdgeId edge(EdgeId old) { return EdgeId(int(edges(number_of(old)))); }
    HalfedgeId halfedge(HalfedgeId old)
    {
        const HalfedgeId first = first_halfedge(edge(edge_of(old)));
        return old == first_halfedge(edge_of(old)) ? first : opposite(first);
    }
};

/// Writes the triangles to `slots`, which has room for them.
void copy_triangles(const Universe& u, std::span<Segment* const> order, AppendBuffer<Triangle, SlotId>& slots,
                    Copied& copied)
{
    for (const Segment* segment : order)
        for (const TriangleTree::Run& run : segment->runs)
            for (SlotId slot = run.first; slot < run.first + run.count; ++slot) {
                const FaceId face = u.face_of_slot[slot];
                Triangle triangle;
                HalfedgeId h = u.mesh.halfedge_of(face);
                for (std::size_t c = 0; c < 3; ++c, h = u.mesh.next(h)) {
                    triangle[c] = copied.vertices(u.slots[slot][c]);
                    static_cast<void>(copied.point(u.mesh.from(h)));
                    static_cast<void>(copied.edge(edge_of(h)));
                }
                slots.push(triangle);
                copied.old_face.push_back(face);
            }
}

void copy_connectivity(const Universe& u, Copied& copied, SurfaceMesh& mesh)
{
    for (std::size_t f = 0; f < copied.old_face.size(); ++f) {
        std::array<HalfedgeId, 3> h;
        h[0] = u.mesh.halfedge_of(copied.old_face[f]);
        h[1] = u.mesh.next(h[0]);
        h[2] = u.mesh.next(h[1]);
        mesh.set_triangle(FaceId(int(f)), copied.halfedge(h[0]), copied.halfedge(h[1]), copied.halfedge(h[2]));
        for (const HalfedgeId old : h) {
            mesh.set_to(copied.halfedge(old), copied.point(u.mesh.to(old)));
            const HalfedgeId across = opposite(old);
            if (!u.mesh.is_boundary(across)) continue;
            mesh.set_to(copied.halfedge(across), copied.point(u.mesh.to(across)));
            mesh.link(copied.halfedge(across), copied.halfedge(u.mesh.next(across)));
        }
    }
    for (std::size_t p = 0; p < copied.points.size(); ++p) {
        const PointId old(int(copied.points.old()[p])), point{int(p)};
        mesh.set_halfedge_of(point, copied.halfedge(u.mesh.halfedge_of(old)));
        mesh.set_position(point, u.mesh.position(old));
    }
}

void copy_vertices(const Universe& u, std::span<const Index> old_vertices, Universe& v)
{
    for (const Index old : old_vertices) v.vertices.push(u.vertices[old]);
    for (std::size_t s = 0; s < u.streams.size(); ++s) {
        const Stream& from = u.streams[s];
        for (const Index old : old_vertices)
            for (std::size_t i = 0; i < from.width; ++i)
                v.streams[s].values.push(from.values[std::size_t(old) * from.width + i]);
    }
}

void copy_faces(const Universe& u, std::span<const FaceId> old_face, Universe& v)
{
    v.stamp_of_face.set_size(old_face.size());
    std::fill(v.stamp_of_face.begin(), v.stamp_of_face.end(), Index(0));
    for (std::size_t f = 0; f < old_face.size(); ++f) {
        v.face_of_slot.push(FaceId(int(f)));
        v.source_of_face.push(u.source_of_face[old_face[f]]);
    }
}

/// Trees over segments in drawing order, joined for each shell in the order of its old tree.
void plant_trees(std::span<Segment* const> order, std::span<const Segment> segments, std::span<ShellRoot> shells,
                 Universe& v)
{
    SlotId first(0);
    for (Segment* segment : order) {
        segment->root = v.tree.make_run(v.geometry(), first, segment->count, segment->group);
        first = first + segment->count;
    }
    for (std::size_t begin = 0, end; begin < segments.size(); begin = end) {
        end = begin;
        while (end < segments.size() && segments[end].shell == segments[begin].shell) ++end;
        shells[segments[begin].shell].root = join_all(v.tree, segments.subspan(begin, end - begin));
    }
}

}  // namespace

std::vector<ShellRoot> compact_copy(const Universe& u, std::span<const ShellRoot> shells, Universe& v)
{
    v.groups = u.groups;
    v.set_materials(u.materials);
    v.cap_material = u.cap_material;
    v.reference = u.reference;
    v.noise = u.noise;
    v.has_boundary = u.has_boundary;
    for (const Stream& stream : u.streams) v.streams.push_back({stream.name, stream.width, {}});

    Segments segments(u, shells);
    const std::vector<Segment*> order = in_drawing_order(u, segments.list());
    UniverseSize size;
    for (const Segment& segment : segments.list()) {
        size.triangles += segment.count;
        size.nodes += TriangleTree::nodes_of_full_leaves(segment.count) + 1;
    }
    v.slots.reserve(size.triangles);
    Copied copied(u, size.triangles);
    copy_triangles(u, order, v.slots, copied);

    size.points = copied.points.size();
    size.edges = copied.edges.size();
    size.vertices = copied.vertices.size();
    reserve(v, size, crossings_of_one_cut(size.triangles));
    v.mesh.resize(size.points, size.edges, size.triangles);
    v.mesh.touch_room();
    reserve_nodes(v, size, crossings_of_one_cut(size.triangles));
    copy_connectivity(u, copied, v.mesh);
    copy_vertices(u, copied.vertices.old(), v);
    copy_faces(u, copied.old_face, v);
    std::vector<ShellRoot> copies(shells.begin(), shells.end());
    plant_trees(order, segments.list(), copies, v);
    return copies;
}

}  // namespace kerf::core::halfedge
