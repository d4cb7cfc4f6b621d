#include "halfedge/cut/irregular/irregular.h"

#include <algorithm>
#include <tuple>
#include <unordered_set>

#include "halfedge/cut/irregular/coinciding_points.h"

namespace kerf::core::halfedge {

namespace {

/// An edge of a triangle that one side keeps, between two points of the outline or beside it.
struct KeptEdge
{
    Side side;
    Index from, to;  ///< classes of points, the smaller one first
    TargetId target;
    auto operator<=>(const KeptEdge&) const = default;

    std::tuple<Side, Index, Index> place() const { return {side, from, to}; }
};

KeptEdge kept_edge(Side side, Index a, Index b, TargetId target, CoincidingPoints& classes)
{
    a = classes.find(a);
    b = classes.find(b);
    return {side, std::min(a, b), std::max(a, b), target};
}

KeptEdge kept_edge(const Universe& u, Side side, HalfedgeId halfedge, TargetId target, CoincidingPoints& classes)
{
    const Index from = classes.of_point(u.mesh.from(halfedge));
    return kept_edge(side, from, classes.of_point(u.mesh.to(halfedge)), target, classes);
}

/// Those of sub-triangles, and those in the plane.
std::vector<KeptEdge> kept_edges(const Universe& u, const Found& found, CoincidingPoints& classes)
{
    std::vector<KeptEdge> edges;
    for (const Crossing& c : found.crossings)
        for (const SubTriangle& sub : c.split.sub_triangles()) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Index from = classes.of_code(c, sub.corners[corner]);
                const Index to = classes.of_code(c, sub.corners[(corner + 1) % 3]);
                edges.push_back(kept_edge(sub.side, from, to, c.target[sub.side], classes));
            }
        }
    for (const InPlaneEdge& e : found.in_plane) {
        edges.push_back(kept_edge(u, Side::negative, e.negative_halfedge, e.target[Side::negative], classes));
        edges.push_back(kept_edge(u, Side::positive, e.positive_halfedge, e.target[Side::positive], classes));
    }
    for (const FlushEdge& e : found.flush) edges.push_back(kept_edge(u, e.side, e.halfedge, e.target, classes));
    return edges;
}

/// Those of whole triangles beside crossing ones.
void add_edges_beside_crossings(const Universe& u, const Found& found, CoincidingPoints& classes,
                                std::vector<KeptEdge>& edges)
{
    std::unordered_set<FaceId> crosses;
    for (const Crossing& c : found.crossings) crosses.insert(c.face);
    for (const Crossing& c : found.crossings)
        for (std::size_t i = 0; i < 3; ++i) {
            const double from = c.distance[i], to = c.distance[(i + 1) % 3];
            const HalfedgeId across = opposite(c.halfedge[i]);
            // Between corners of one side: the triangle across is whole, or it crosses. What lies in the plane is
            // there.
            const bool is_above = std::max(from, to) > 0.0, is_below = std::min(from, to) < 0.0;
            if (is_above == is_below || u.mesh.is_boundary(across) || crosses.contains(u.mesh.face(across))) continue;
            const Side side = is_above ? Side::positive : Side::negative;
            edges.push_back(kept_edge(u, side, across, c.target[side], classes));
        }
}

/// Whether a sub-triangle on the side has the section edge.
bool has_triangle_at_section(const TriangleSplit& split, Side side)
{
    return std::ranges::any_of(split.sub_triangles(), [&](const auto& sub) {
        const auto has = [&](std::uint8_t code) {
            return std::find(sub.corners.begin(), sub.corners.end(), code) != sub.corners.end();
        };
        return sub.side == side && has(split.section_from) && has(split.section_to);
    });
}

}  // namespace

std::vector<std::array<TargetId, 2>> targets_that_share_edges(const Universe& u, const Found& found,
                                                              const Section& section)
{
    CoincidingPoints classes(u, found, section);
    std::vector<KeptEdge> edges = kept_edges(u, found, classes);
    std::sort(edges.begin(), edges.end());
    std::vector<std::array<TargetId, 2>> pairs;
    for (std::size_t i = 1; i < edges.size(); ++i) {
        const KeptEdge &a = edges[i - 1], &b = edges[i];
        if (a.place() == b.place() && a.target != b.target) pairs.push_back({a.target, b.target});
    }
    return pairs;
}

void find_edges_that_bound_nothing(const Universe& u, const Section& section, Found& found)
{
    std::vector<std::pair<Index, Side>> vanished;
    for (Index i = 0; i < found.crossings.size(); ++i)
        for (const Side side : {Side::negative, Side::positive})
            if (found.crossings[i].split.has_section_edge() && !has_triangle_at_section(found.crossings[i].split, side))
                vanished.push_back({i, side});
    if (vanished.empty()) return;

    CoincidingPoints classes(u, found, section);
    std::vector<KeptEdge> edges = kept_edges(u, found, classes);
    add_edges_beside_crossings(u, found, classes, edges);
    std::sort(edges.begin(), edges.end());
    for (const auto& [i, side] : vanished) {
        Crossing& c = found.crossings[i];
        const Index from = classes.find(classes.of_code(c, c.split.section_from));
        const Index to = classes.find(classes.of_code(c, c.split.section_to));
        const KeptEdge edge{side, std::min(from, to), std::max(from, to), TargetId(0)};
        const auto place = std::lower_bound(edges.begin(), edges.end(), edge);
        if (place == edges.end() || place->place() != edge.place()) c.bounds_nothing[side] = true;
    }
}

}  // namespace kerf::core::halfedge
