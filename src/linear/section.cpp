#include "linear/section.h"

#include <algorithm>
#include <unordered_map>

#include "common/caps/section_area.h"
#include "common/geometry/pair_table.h"

namespace kerf::core::linear {

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

/// Removes pairs of opposite edges, wherever they were found.
void cancel_opposite_edges(Section& section)
{
    for (const auto& pair : opposite_edges(section.points.size(), outline_of(section))) {
        section.has_cancelled_edges = true;
        for (const std::uint32_t edge : pair) section.edges[edge].from = kNone;
    }
    std::erase_if(section.edges, [](const SectionEdge& edge) { return edge.from == kNone; });
}

/// An edge in the plane as it runs on the positive side, with what is known of all triangles at it.
struct SectionEdgeInPlane
{
    EdgeInPlane edge;
    std::uint32_t source;    // the least
    std::uint32_t material;  // of the one on the negative side with the least source
};

/// The two vertices of an edge in the plane.
std::array<std::uint32_t, 2> ends_of(const IndexedMesh& mesh, const EdgeInPlane& edge)
{
    const Triangle& t = mesh.triangles[edge.triangle];
    return {t[edge.corner], t[(edge.corner + 1u) % 3]};
}

/// The edges in the plane that have a triangle of either side, as they run on the positive side. They are counted,
/// because pieces of earlier cuts can touch along an edge, so that more than two triangles meet there. Edges that run
/// forth and back on one side bound nothing there; each of the rest pairs with one reverse on the other side.
std::vector<SectionEdgeInPlane> section_edges_in_plane(const IndexedMesh& mesh, std::span<const EdgeInPlane> negative,
                                                       std::span<const EdgeInPlane> positive)
{
    if (negative.empty() || positive.empty()) return {};
    struct Row
    {
        std::int32_t below = 0, above = 0;       // edges that ascend less those that do not
        std::uint32_t source = kNoSource;        // the least
        std::uint32_t source_below = kNoSource;  // the least on the negative side
        std::uint32_t group_below = kNone;       // and its group
    };
    PairTable row_at;  // by the edge's points, the smaller one first
    row_at.reset(negative.size() + positive.size());
    std::vector<Row> rows;
    const auto row_of = [&](const EdgeInPlane& edge, std::int32_t& direction) -> Row& {
        const auto [a, b] = ends_of(mesh, edge);
        const std::uint32_t p = mesh.points[a], q = mesh.points[b];
        direction = p < q ? 1 : -1;
        std::uint32_t& index = row_at(std::min(p, q), std::max(p, q));
        if (index == kNone) {
            index = static_cast<std::uint32_t>(rows.size());
            rows.emplace_back();
        }
        Row& row = rows[index];
        row.source = std::min(row.source, mesh.sources[edge.triangle]);
        return row;
    };
    std::int32_t direction = 0;
    for (const EdgeInPlane& edge : negative) {
        Row& row = row_of(edge, direction);
        row.below += direction;
        const std::uint32_t source = mesh.sources[edge.triangle];
        if (row.group_below != kNone && source >= row.source_below) continue;
        row.source_below = source;
        row.group_below = edge.group;
    }
    for (const EdgeInPlane& edge : positive) {
        Row& row = row_of(edge, direction);
        row.above += direction;
    }
    std::vector<SectionEdgeInPlane> result;
    for (const EdgeInPlane& edge : positive) {
        Row& row = row_of(edge, direction);
        if (row.above * direction <= 0 || row.below * direction >= 0) continue;
        row.above -= direction;
        row.below += direction;
        result.push_back({edge, row.source, mesh.groups[row.group_below].material});
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

    for (std::uint32_t i = 0; i < crossings.triangles.size(); ++i) {
        const CrossingTriangle& crossing = crossings.triangles[i];
        const TriangleSplit& split = crossing.split;
        if (!split.has_section_edge()) continue;
        const std::uint32_t from = numbers.of_corner(crossing, split.section_from);
        const std::uint32_t to = numbers.of_corner(crossing, split.section_to);
        if (from == to) continue;
        section.edges.push_back({from, to, i, crossing.triangle, split.section_from, split.section_to,
                                 mesh.groups[crossing.group].solid, mesh.sources[crossing.triangle],
                                 mesh.groups[crossing.group].material});
    }
    for (const auto& [edge, source, material] :
         section_edges_in_plane(mesh, in_plane_of_negative, in_plane_of_positive)) {
        const auto [from, to] = ends_of(mesh, edge);
        section.edges.push_back({numbers.of_vertex(from), numbers.of_vertex(to), kNone, edge.triangle, edge.corner,
                                 static_cast<std::uint8_t>((edge.corner + 1u) % 3), mesh.groups[edge.group].solid,
                                 source, material});
    }
    cancel_opposite_edges(section);
    return section;
}

std::vector<OutlineEdge> outline_of(const Section& section)
{
    std::vector<OutlineEdge> outline;
    outline.reserve(section.edges.size());
    for (const SectionEdge& edge : section.edges) outline.push_back({edge.from, edge.to, {}, edge.source});
    return outline;
}

std::vector<glm::vec3> positions_of(const Section& section)
{
    std::vector<glm::vec3> positions;
    positions.reserve(section.points.size());
    for (const SectionPoint& point : section.points) positions.push_back(point.position);
    return positions;
}

std::vector<SectionPath> link_paths(const Plane& plane, const Section& section, std::span<const std::uint64_t> tags)
{
    const DividedOutline divided = divide_outline(plane, positions_of(section), outline_of(section), tags);
    std::vector<SectionPath> paths;
    paths.reserve(divided.paths.size());
    for (const OutlinePath& path : divided.paths) {
        const auto first = divided.edges.begin() + static_cast<std::ptrdiff_t>(path.first);
        paths.push_back({{first, first + static_cast<std::ptrdiff_t>(path.count)}, path.closed});
    }
    return paths;
}

double area_of(const Section& section, std::span<const SectionPath> paths, const Plane& plane)
{
    return section_area(plane, [&](auto visit) {
        for (const SectionPath& path : paths) {
            if (!path.closed) continue;
            for (const std::uint32_t e : path.edges)
                visit(section.points[section.edges[e].from].position, section.points[section.edges[e].to].position);
        }
    });
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

}  // namespace kerf::core::linear
