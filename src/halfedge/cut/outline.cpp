#include "halfedge/cut/outline.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace kerf::halfedge {

namespace {

/// Classes of coinciding points: union-find over cut points and, as they turn up, vertices of the half-edge mesh.
class PointClasses
{
public:
    explicit PointClasses(const CutScratch& scratch) : position_(scratch.cut_points), parent_(position_.size())
    {
        for (Index i = 0; i < parent_.size(); ++i) parent_[i] = i;
    }

    Index of_vertex(const SurfaceMesh& mesh, Index vertex)
    {
        const auto [entry, is_new] = of_vertex_.try_emplace(vertex, static_cast<Index>(parent_.size()));
        if (is_new) {
            parent_.push_back(entry->second);
            position_.push_back(mesh.point(vertex));
        }
        return entry->second;
    }

    Index find(Index i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void unite(Index a, Index b)
    {
        a = find(a);
        b = find(b);
        // The smaller one stays, whatever the order of the calls.
        if (a != b) parent_[std::max(a, b)] = std::min(a, b);
    }

    std::size_t size() const { return parent_.size(); }
    const glm::vec3& position(Index i) const { return position_[i]; }

private:
    std::vector<glm::vec3> position_;
    std::vector<Index> parent_;
    std::unordered_map<Index, Index> of_vertex_;
};

/// The element of a corner of a crossing triangle.
Index element_of_code(const Universe& u, const Crossing& c, std::uint8_t code, PointClasses& classes)
{
    if (code == TriangleSplit::kCutNext) return c.n_cut_point();
    if (code == TriangleSplit::kCutPrevious) return c.p_cut_point();
    return classes.of_vertex(u.mesh, c.point[code]);
}

void unite_coinciding(const Universe& u, const CutScratch& s, PointClasses& classes)
{
    for (const Crossing& c : s.crossings) {
        if (c.n_cut_point() != kNone) classes.unite(c.n_cut_point(), element_of_code(u, c, c.split.next_code, classes));
        if (c.p_cut_point() != kNone)
            classes.unite(c.p_cut_point(), element_of_code(u, c, c.split.previous_code, classes));
    }
}

/// Collects the outline edges with the classes of their ends, and says which cut points are shared.
void collect_outline_edges(const Universe& u, CutScratch& s)
{
    PointClasses classes(s);
    unite_coinciding(u, s, classes);
    const auto add = [&](OutlineEdgeId outline_edge, Index from, Index to) {
        from = classes.find(from);
        to = classes.find(to);
        if (from != to) s.outline.push_back({outline_edge, from, to});
    };
    for (OutlineEdgeId i = 0; i < s.crossings.size(); ++i) {
        const Crossing& c = s.crossings[i];
        if (!c.split.has_section_edge()) continue;
        const Index from = element_of_code(u, c, c.split.section_from, classes);
        add(i, from, element_of_code(u, c, c.split.section_to, classes));
    }
    for (OutlineEdgeId i = 0; i < s.in_plane.size(); ++i) {
        // As seen in the positive side's surface.
        const Index h = s.in_plane[i].positive_halfedge;
        const Index from = classes.of_vertex(u.mesh, u.mesh.from(h));
        add(static_cast<OutlineEdgeId>(s.crossings.size()) + i, from, classes.of_vertex(u.mesh, u.mesh.to(h)));
    }
    // A cut point that is alone is one vertex on each side.
    std::vector<Index> members(classes.size(), 0);
    for (Index i = 0; i < classes.size(); ++i) ++members[classes.find(i)];
    for (Index i = 0; i < s.cut_points.size(); ++i) s.cut_point_is_shared[i] = members[classes.find(i)] > 1 ? 1 : 0;
    s.any_shared = true;
    s.outline_points.resize(classes.size());
    for (Index i = 0; i < classes.size(); ++i) s.outline_points[i] = classes.position(i);
}

/// Takes out pairs of outline edges that run forth and back.
void cancel_outline_edges(const Universe& u, CutScratch& s)
{
    std::vector<bool> gone(s.outline.size(), false);
    for (const auto& [a, b] : opposite_edges(s.outline_points.size(), outline_edges(u, s))) {
        s.cancelled.push_back({s.outline[a].id, s.outline[b].id});
        gone[a] = gone[b] = true;
    }
    if (s.cancelled.empty()) return;
    std::size_t kept = 0;
    for (Index i = 0; i < s.outline.size(); ++i)
        if (!gone[i]) s.outline[kept++] = s.outline[i];
    s.outline.resize(kept);
}

/// Divides the outline into loops and chains, those of one tag after one another.
void divide(const Universe& u, const Plane& plane, std::span<const std::uint64_t> tags, CutScratch& s)
{
    const DividedOutline divided = divide_outline(plane, s.outline_points, outline_edges(u, s), tags);
    for (const OutlinePath& path : divided.paths) {
        const auto edge = [&](std::size_t i) -> const ClassedEdge& { return s.outline[divided.edges[path.first + i]]; };
        Loop loop;
        loop.first = s.loop_edges.size();
        loop.count = path.count;
        // What bounds nothing on a side is no loop to be closed.
        loop.closed = path.closed && !s.bounds_nothing(edge(0).id, Side::negative) &&
                      !s.bounds_nothing(edge(0).id, Side::positive);
        loop.solid = u.groups[s.group_of(edge(0).id)].solid;
        loop.shell = s.shell_of(edge(0).id);
        for (std::size_t i = 0; i < path.count; ++i) {
            s.loop_edges.push_back(edge(i).id);
            s.loop_points.push_back(s.outline_points[edge(i).from]);
        }
        if (!loop.closed) loop.end = s.outline_points[edge(path.count - 1).to];
        s.loops.push_back(loop);
    }
}

/// An edge of a triangle that one side keeps, between two points of the outline or beside it.
struct KeptEdge
{
    Side side;
    Index from, to;  ///< classes of points, the smaller one first
    Index target;
    auto operator<=>(const KeptEdge&) const = default;

    std::tuple<Side, Index, Index> place() const { return {side, from, to}; }
};

KeptEdge kept_edge(Side side, Index a, Index b, Index target, PointClasses& classes)
{
    a = classes.find(a);
    b = classes.find(b);
    return {side, std::min(a, b), std::max(a, b), target};
}

KeptEdge kept_edge(const Universe& u, Side side, Index halfedge, Index target, PointClasses& classes)
{
    const Index from = classes.of_vertex(u.mesh, u.mesh.from(halfedge));
    return kept_edge(side, from, classes.of_vertex(u.mesh, u.mesh.to(halfedge)), target, classes);
}

/// Those of the pieces of crossing triangles, and those in the plane.
std::vector<KeptEdge> kept_edges(const Universe& u, const CutScratch& s, PointClasses& classes)
{
    std::vector<KeptEdge> edges;
    for (const Crossing& c : s.crossings)
        for (const SubTriangle& piece : c.split.sub_triangles()) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Index from = element_of_code(u, c, piece.corners[corner], classes);
                const Index to = element_of_code(u, c, piece.corners[(corner + 1) % 3], classes);
                edges.push_back(kept_edge(piece.side, from, to, c.target[piece.side], classes));
            }
        }
    for (const InPlaneEdge& e : s.in_plane) {
        edges.push_back(kept_edge(u, Side::negative, e.negative_halfedge, e.target[Side::negative], classes));
        edges.push_back(kept_edge(u, Side::positive, e.positive_halfedge, e.target[Side::positive], classes));
    }
    for (const FlushEdge& e : s.flush) edges.push_back(kept_edge(u, e.side, e.halfedge, e.target, classes));
    return edges;
}

/// Those of whole triangles beside crossing ones.
void add_edges_beside_crossings(const Universe& u, const CutScratch& s, PointClasses& classes,
                                std::vector<KeptEdge>& edges)
{
    std::unordered_set<Index> crosses;
    for (const Crossing& c : s.crossings) crosses.insert(c.face);
    for (const Crossing& c : s.crossings)
        for (std::size_t i = 0; i < 3; ++i) {
            const double from = c.distance[i], to = c.distance[(i + 1) % 3];
            const Index opposite = u.mesh.opposite(c.halfedge[i]);
            // Between corners of one side: the triangle across is whole, or it crosses. What lies in the plane is
            // there.
            const bool is_above = std::max(from, to) > 0.0, is_below = std::min(from, to) < 0.0;
            if (is_above == is_below || u.mesh.is_boundary(opposite) || crosses.contains(u.mesh.face(opposite)))
                continue;
            const Side side = is_above ? Side::positive : Side::negative;
            edges.push_back(kept_edge(u, side, opposite, c.target[side], classes));
        }
}

/// False where all that the split leaves on a side does without the section's edge.
bool has_piece_at_section(const TriangleSplit& split, Side side)
{
    return std::ranges::any_of(split.sub_triangles(), [&](const auto& piece) {
        const auto has = [&](std::uint8_t code) {
            return std::find(piece.corners.begin(), piece.corners.end(), code) != piece.corners.end();
        };
        return piece.side == side && has(split.section_from) && has(split.section_to);
    });
}

}  // namespace

std::vector<OutlineEdge> outline_edges(const Universe& u, const CutScratch& s)
{
    std::vector<OutlineEdge> edges;
    edges.reserve(s.outline.size());
    for (const ClassedEdge& e : s.outline) edges.push_back({e.from, e.to, {}, s.source_of(u, e.id)});
    return edges;
}

void link_outline(const Universe& universe, const Plane& plane, CutScratch& scratch)
{
    collect_outline_edges(universe, scratch);
    cancel_outline_edges(universe, scratch);
    std::vector<std::uint64_t> solids;
    solids.reserve(scratch.outline.size());
    for (const ClassedEdge& e : scratch.outline) solids.push_back(universe.groups[scratch.group_of(e.id)].solid);
    divide(universe, plane, solids, scratch);
}

void relink_outline(const Universe& universe, const Plane& plane, CutScratch& scratch)
{
    scratch.loops.clear();
    scratch.loop_edges.clear();
    scratch.loop_points.clear();
    std::vector<std::uint64_t> piece_shells;
    piece_shells.reserve(scratch.outline.size());
    for (const ClassedEdge& e : scratch.outline) {
        BySide<Index> piece_shell = scratch.piece_shells_of(e.id);
        for (const Side side : {Side::negative, Side::positive})
            if (scratch.bounds_nothing(e.id, side)) piece_shell[side] = kNone;
        piece_shells.push_back(std::uint64_t{piece_shell[Side::negative]} << 32 | piece_shell[Side::positive]);
    }
    divide(universe, plane, piece_shells, scratch);
}

std::vector<std::array<Index, 2>> targets_that_share_edges(const Universe& u, const CutScratch& s)
{
    PointClasses classes(s);
    unite_coinciding(u, s, classes);
    std::vector<KeptEdge> edges = kept_edges(u, s, classes);
    std::sort(edges.begin(), edges.end());
    std::vector<std::array<Index, 2>> pairs;
    for (std::size_t i = 1; i < edges.size(); ++i) {
        const KeptEdge &a = edges[i - 1], &b = edges[i];
        if (a.place() == b.place() && a.target != b.target) pairs.push_back({a.target, b.target});
    }
    return pairs;
}

void find_edges_that_bound_nothing(const Universe& u, CutScratch& s)
{
    std::vector<std::pair<Index, Side>> vanished;
    for (Index i = 0; i < s.crossings.size(); ++i)
        for (const Side side : {Side::negative, Side::positive})
            if (s.crossings[i].split.has_section_edge() && !has_piece_at_section(s.crossings[i].split, side))
                vanished.push_back({i, side});
    if (vanished.empty()) return;

    PointClasses classes(s);
    unite_coinciding(u, s, classes);
    std::vector<KeptEdge> edges = kept_edges(u, s, classes);
    add_edges_beside_crossings(u, s, classes, edges);
    std::sort(edges.begin(), edges.end());
    for (const auto& [i, side] : vanished) {
        Crossing& c = s.crossings[i];
        const Index from = classes.find(element_of_code(u, c, c.split.section_from, classes));
        const Index to = classes.find(element_of_code(u, c, c.split.section_to, classes));
        const KeptEdge edge{side, std::min(from, to), std::max(from, to), 0};
        const auto found = std::lower_bound(edges.begin(), edges.end(), edge);
        if (found == edges.end() || found->place() != edge.place()) c.bounds_nothing[side] = true;
    }
}

}  // namespace kerf::halfedge
