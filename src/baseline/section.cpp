#include "baseline/section.h"

#include <algorithm>
#include <unordered_map>

#include "baseline/pair_table.h"
#include "common/outgoing_edges.h"

namespace kerf::baseline {

namespace {

/// Gives section points their numbers.
class PointNumbers
{
public:
    PointNumbers(const IndexedMesh& mesh, Crossings& crossings, Section& section)
        : mesh_(mesh), crossings_(crossings), section_(section), of_cut_point_(crossings.cut_points.size(), kNone)
    {
    }

    /// The section point at a corner of a crossing triangle.
    std::uint32_t of_corner(const CrossingTriangle& crossing, std::uint8_t code)
    {
        if (code < 3) return of_vertex(mesh_.triangles[crossing.triangle][code]);
        const std::uint32_t id = crossings_.cut_point(crossing, code);
        const glm::vec3& position =
            code == TriangleSplit::kCutNext ? crossing.split.cut_next.position : crossing.split.cut_previous.position;
        const std::uint32_t existing = crossings_.cut_points.existing(id);
        if (existing != kNone) return of_existing(existing, position);
        if (of_cut_point_[id] == kNone) of_cut_point_[id] = add({position, kNone, id});
        return of_cut_point_[id];
    }

    std::uint32_t of_vertex(std::uint32_t vertex)
    {
        return of_existing(mesh_.points[vertex], mesh_.vertices[vertex].position);
    }

private:
    std::uint32_t of_existing(std::uint32_t point, const glm::vec3& position)
    {
        point = crossings_.cut_points.standing_for(point);
        const auto [entry, is_new] = of_existing_.try_emplace(point, kNone);
        if (is_new) entry->second = add({position, point, kNone});
        return entry->second;
    }

    std::uint32_t add(const SectionPoint& point)
    {
        section_.points.push_back(point);
        return static_cast<std::uint32_t>(section_.points.size() - 1);
    }

    const IndexedMesh& mesh_;
    Crossings& crossings_;
    Section& section_;
    std::vector<std::uint32_t> of_cut_point_;
    std::unordered_map<std::uint32_t, std::uint32_t> of_existing_;
};

/// Removes pairs of opposite edges, whatever they were found in.
void cancel_opposite_edges(std::vector<SectionEdge>& edges)
{
    PairTable edge_between;
    edge_between.reset(edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        SectionEdge& edge = edges[i];
        const std::uint32_t other = edge_between.find(edge.to, edge.from);
        if (other != kNone && edges[other].from != kNone) {
            edge.from = edges[other].from = kNone;
            continue;
        }
        edge_between(edge.from, edge.to) = i;
    }
    std::erase_if(edges, [](const SectionEdge& edge) { return edge.from == kNone; });
}

/// Some edge has its reverse. Where no points coincide only one edge leaves each point, so that a look suffices.
bool runs_forth_and_back(const Section& section)
{
    std::vector<std::uint32_t> next(section.points.size(), kNone);
    for (const SectionEdge& edge : section.edges) next[edge.from] = edge.to;
    return std::any_of(section.edges.begin(), section.edges.end(),
                       [&](const SectionEdge& edge) { return next[edge.to] == edge.from; });
}

/// The two vertices of an edge in the plane.
std::array<std::uint32_t, 2> ends_of(const IndexedMesh& mesh, const EdgeInPlane& edge)
{
    const Triangle& t = mesh.triangles[edge.triangle];
    return {t[edge.corner], t[(edge.corner + 1u) % 3]};
}

/// The edges, as they run on the positive side, that have a triangle of either side. By count: pieces of earlier cuts
/// can touch along an edge, so that more than two triangles meet there. Edges that run forth and back on one side bound
/// nothing there; each of the rest pairs with one reverse on the other side.
std::vector<EdgeInPlane> section_edges_in_plane(const IndexedMesh& mesh, const CutPointClasses& points,
                                                std::span<const EdgeInPlane> negative,
                                                std::span<const EdgeInPlane> positive)
{
    if (negative.empty() || positive.empty()) return {};
    PairTable row;  // by the edge's points, the smaller one first
    row.reset(negative.size() + positive.size());
    std::vector<std::array<std::int32_t, 2>>
        surplus;  // for each row and side: edges that ascend less those that do not
    const auto row_of = [&](const EdgeInPlane& edge, std::int32_t& direction) {
        const auto [a, b] = ends_of(mesh, edge);
        const std::uint32_t p = points.standing_for(mesh.points[a]), q = points.standing_for(mesh.points[b]);
        direction = p < q ? 1 : -1;
        std::uint32_t& index = row(std::min(p, q), std::max(p, q));
        if (index == PairTable::kNone) {
            index = static_cast<std::uint32_t>(surplus.size());
            surplus.push_back({0, 0});
        }
        return index;
    };
    std::int32_t direction = 0;
    for (const EdgeInPlane& edge : negative) {
        const std::uint32_t i = row_of(edge, direction);
        surplus[i][0] += direction;
    }
    for (const EdgeInPlane& edge : positive) {
        const std::uint32_t i = row_of(edge, direction);
        surplus[i][1] += direction;
    }
    std::vector<EdgeInPlane> result;
    for (const EdgeInPlane& edge : positive) {
        auto& [below, above] = surplus[row_of(edge, direction)];
        if (above * direction <= 0 || below * direction >= 0) continue;
        above -= direction;
        below += direction;
        result.push_back(edge);
    }
    return result;
}

}  // namespace

Section find_section(const IndexedMesh& mesh, Crossings& crossings, std::span<const EdgeInPlane> in_plane_of_negative,
                     std::span<const EdgeInPlane> in_plane_of_positive)
{
    Section section;
    section.points.reserve(crossings.cut_points.size());
    section.edges.reserve(crossings.triangles.size());
    PointNumbers numbers(mesh, crossings, section);

    bool some_coincide = false;
    for (std::uint32_t i = 0; i < crossings.triangles.size(); ++i) {
        const CrossingTriangle& crossing = crossings.triangles[i];
        const TriangleSplit& split = crossing.split;
        some_coincide |= split.next_code < 3 || split.previous_code != TriangleSplit::kCutPrevious;
        if (!split.has_section_edge()) continue;
        const std::uint32_t from = numbers.of_corner(crossing, split.section_from);
        const std::uint32_t to = numbers.of_corner(crossing, split.section_to);
        if (from == to) continue;
        section.edges.push_back(
            {from, to, i, crossing.triangle, split.section_from, split.section_to, mesh.groups[crossing.group].solid});
    }
    const std::size_t from_crossings = section.edges.size();
    for (const EdgeInPlane& edge :
         section_edges_in_plane(mesh, crossings.cut_points, in_plane_of_negative, in_plane_of_positive)) {
        const auto [from, to] = ends_of(mesh, edge);
        section.edges.push_back({numbers.of_vertex(from), numbers.of_vertex(to), kNone, edge.triangle, edge.corner,
                                 static_cast<std::uint8_t>((edge.corner + 1u) % 3), mesh.groups[edge.group].solid});
    }
    some_coincide |= section.edges.size() > from_crossings;
    if (some_coincide || runs_forth_and_back(section)) cancel_opposite_edges(section.edges);
    return section;
}

std::vector<SectionPath> link_paths(const Section& section, std::span<const std::uint32_t> tags)
{
    const std::size_t edge_count = section.edges.size(), point_count = section.points.size();
    std::vector<std::int32_t> surplus(point_count, 0);  // outgoing less incoming edges
    for (const SectionEdge& edge : section.edges) {
        ++surplus[edge.from];
        --surplus[edge.to];
    }
    OutgoingEdges outgoing(
        point_count, edge_count, [&](std::uint32_t edge) { return section.edges[edge].from; },
        [&](std::uint32_t edge) { return tags[edge]; });

    std::vector<SectionPath> paths;
    std::vector<std::uint32_t> place(point_count, kNone);  // where on the current path a point's outgoing edge is
    const auto follow = [&](std::uint32_t first) {
        const std::uint32_t tag = tags[first];
        std::vector<std::uint32_t> path;
        for (std::uint32_t edge = first; edge != kNone;) {
            outgoing.use(edge);
            place[section.edges[edge].from] = static_cast<std::uint32_t>(path.size());
            path.push_back(edge);
            const std::uint32_t to = section.edges[edge].to;
            if (place[to] != kNone) {
                // Back at a point of the path: what lies between is a loop that visits no point twice.
                const auto begin = path.begin() + place[to];
                for (auto it = begin; it != path.end(); ++it) place[section.edges[*it].from] = kNone;
                paths.push_back({{begin, path.end()}, true, tag});
                path.erase(begin, path.end());
            }
            edge = outgoing.next(to, tag);
        }
        for (const std::uint32_t edge : path) place[section.edges[edge].from] = kNone;
        if (!path.empty()) paths.push_back({std::move(path), false, tag});
    };

    // Chains first, from where they begin, or a loop could swallow a part of one.
    for (std::uint32_t i = 0; i < edge_count; ++i) {
        std::int32_t& begins = surplus[section.edges[i].from];
        if (outgoing.is_used(i) || begins <= 0) continue;
        --begins;
        follow(i);
    }
    for (std::uint32_t i = 0; i < edge_count; ++i)
        if (!outgoing.is_used(i)) follow(i);
    return paths;
}

double signed_area(const Section& section, const SectionPath& path, const Plane& plane)
{
    const glm::dvec3 origin(section.points[section.edges[path.edges.front()].from].position);
    glm::dvec3 twice{0.0};
    for (const std::uint32_t i : path.edges) {
        const SectionEdge& edge = section.edges[i];
        twice += glm::cross(glm::dvec3(section.points[edge.from].position) - origin,
                            glm::dvec3(section.points[edge.to].position) - origin);
    }
    return glm::dot(twice, plane.normal) * 0.5;
}

SectionLoop to_loop(const Section& section, const SectionPath& path)
{
    SectionLoop loop;
    loop.closed = path.closed;
    loop.points.reserve(path.edges.size() + 1);
    for (const std::uint32_t i : path.edges) loop.points.push_back(section.points[section.edges[i].from].position);
    if (!path.closed) loop.points.push_back(section.points[section.edges[path.edges.back()].to].position);
    return loop;
}

}  // namespace kerf::baseline
