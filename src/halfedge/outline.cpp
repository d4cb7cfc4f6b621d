#include "halfedge/outline.h"

#include <algorithm>
#include <unordered_map>

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
    if (code == TriangleSplit::kCutNext) return c.n_cut();
    if (code == TriangleSplit::kCutPrevious) return c.p_cut();
    return classes.of_vertex(u.mesh, c.point[code]);
}

void unite_coinciding(const Universe& u, const CutScratch& s, PointClasses& classes)
{
    for (const Crossing& c : s.crossings) {
        if (c.n_cut() != kNone) classes.unite(c.n_cut(), element_of_code(u, c, c.split.next_code, classes));
        if (c.p_cut() != kNone) classes.unite(c.p_cut(), element_of_code(u, c, c.split.previous_code, classes));
    }
}

/// Collects the seams with the classes of their ends, and says which cut points are shared.
void collect_seams(const Universe& u, CutScratch& s)
{
    PointClasses classes(s);
    unite_coinciding(u, s, classes);
    const auto add = [&](SeamIndex seam, Index from, Index to) {
        from = classes.find(from);
        to = classes.find(to);
        if (from != to) s.outline.push_back({seam, from, to});
    };
    for (SeamIndex i = 0; i < s.crossings.size(); ++i) {
        const Crossing& c = s.crossings[i];
        if (!c.split.has_section_edge()) continue;
        const Index from = element_of_code(u, c, c.split.section_from, classes);
        add(i, from, element_of_code(u, c, c.split.section_to, classes));
    }
    for (SeamIndex i = 0; i < s.in_plane.size(); ++i) {
        // As seen in the positive side's surface.
        const Index h = s.in_plane[i].positive_halfedge;
        const Index from = classes.of_vertex(u.mesh, u.mesh.from(h));
        add(static_cast<SeamIndex>(s.crossings.size()) + i, from, classes.of_vertex(u.mesh, u.mesh.to(h)));
    }
    // A cut point that is alone is one vertex on each side.
    std::vector<Index> members(classes.size(), 0);
    for (Index i = 0; i < classes.size(); ++i) ++members[classes.find(i)];
    for (Index i = 0; i < s.cut_points.size(); ++i) s.shared_cut[i] = members[classes.find(i)] > 1 ? 1 : 0;
    s.any_shared = true;
    s.outline_points.resize(classes.size());
    for (Index i = 0; i < classes.size(); ++i) s.outline_points[i] = classes.position(i);
}

/// Takes out pairs of seams that run forth and back.
void cancel_seams(const Universe& u, CutScratch& s)
{
    std::vector<bool> gone(s.outline.size(), false);
    for (const auto& [a, b] : opposite_edges(s.outline_points.size(), outline_edges(u, s))) {
        s.cancelled.push_back({s.outline[a].seam, s.outline[b].seam});
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
        const auto edge = [&](std::size_t i) -> const OutlineSeam& { return s.outline[divided.edges[path.first + i]]; };
        Loop loop;
        loop.first = s.loop_seams.size();
        loop.count = path.count;
        // What bounds nothing on a side is no loop to be closed.
        loop.closed = path.closed && !s.bounds_nothing(edge(0).seam, Side::negative) &&
                      !s.bounds_nothing(edge(0).seam, Side::positive);
        loop.solid = u.groups[s.group_of_seam(edge(0).seam)].solid;
        loop.shell = s.shell_of_seam(edge(0).seam);
        for (std::size_t i = 0; i < path.count; ++i) {
            s.loop_seams.push_back(edge(i).seam);
            s.loop_points.push_back(s.outline_points[edge(i).from]);
        }
        if (!loop.closed) loop.end = s.outline_points[edge(path.count - 1).to];
        s.loops.push_back(loop);
    }
}

}  // namespace

std::vector<OutlineEdge> outline_edges(const Universe& u, const CutScratch& s)
{
    std::vector<OutlineEdge> edges;
    edges.reserve(s.outline.size());
    for (const OutlineSeam& e : s.outline) edges.push_back({e.from, e.to, {}, s.source_of_seam(u, e.seam)});
    return edges;
}

void link_outline(const Universe& universe, const Plane& plane, CutScratch& scratch)
{
    collect_seams(universe, scratch);
    cancel_seams(universe, scratch);
    std::vector<std::uint64_t> solids;
    solids.reserve(scratch.outline.size());
    for (const OutlineSeam& e : scratch.outline) solids.push_back(universe.groups[scratch.group_of_seam(e.seam)].solid);
    divide(universe, plane, solids, scratch);
}

void relink_outline(const Universe& universe, const Plane& plane, CutScratch& scratch)
{
    scratch.loops.clear();
    scratch.loop_seams.clear();
    scratch.loop_points.clear();
    std::vector<std::uint64_t> bundles;
    bundles.reserve(scratch.outline.size());
    for (const OutlineSeam& e : scratch.outline) {
        std::array<Index, 2> bundle = scratch.bundles_of_seam(e.seam);
        for (const Side side : {Side::negative, Side::positive})
            if (scratch.bounds_nothing(e.seam, side)) bundle[static_cast<std::size_t>(side)] = kNone;
        bundles.push_back(std::uint64_t{bundle[0]} << 32 | bundle[1]);
    }
    divide(universe, plane, bundles, scratch);
}

std::vector<std::array<Index, 2>> targets_that_share_edges(const Universe& u, const CutScratch& s)
{
    PointClasses classes(s);
    unite_coinciding(u, s, classes);
    struct Place
    {
        Side side;
        Index from, to, target;
        auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> places;
    const auto add = [&](Side side, Index a, Index b, Index target) {
        a = classes.find(a);
        b = classes.find(b);
        places.push_back({side, std::min(a, b), std::max(a, b), target});
    };
    for (const Crossing& c : s.crossings)
        for (std::size_t i = 0; i < c.split.piece_count; ++i) {
            const TriangleSplit::Piece& piece = c.split.pieces[i];
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Index from = element_of_code(u, c, piece.corners[corner], classes);
                add(piece.side, from, element_of_code(u, c, piece.corners[(corner + 1) % 3], classes),
                    c.target[static_cast<std::size_t>(piece.side)]);
            }
        }
    const auto add_halfedge = [&](Side side, Index h, Index target) {
        const Index from = classes.of_vertex(u.mesh, u.mesh.from(h));
        add(side, from, classes.of_vertex(u.mesh, u.mesh.to(h)), target);
    };
    for (const InPlaneEdge& e : s.in_plane) {
        add_halfedge(Side::negative, e.negative_halfedge, e.target[0]);
        add_halfedge(Side::positive, e.positive_halfedge, e.target[1]);
    }
    for (const FlushEdge& e : s.flush) add_halfedge(e.side, e.halfedge, e.target);

    std::sort(places.begin(), places.end());
    std::vector<std::array<Index, 2>> pairs;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const Place &a = places[i - 1], &b = places[i];
        if (a.side == b.side && a.from == b.from && a.to == b.to && a.target != b.target)
            pairs.push_back({a.target, b.target});
    }
    return pairs;
}

}  // namespace kerf::halfedge
