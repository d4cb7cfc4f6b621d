#include "linear/section.h"

#include <algorithm>

#include "common/caps/section_area.h"

namespace kerf::core::linear {

namespace {

/// Gives section points their numbers.
class PointNumbers
{
public:
    PointNumbers(const IndexedMesh& mesh, Crossings& crossings, std::vector<std::uint32_t>& of_cut_point,
                 PairTable& of_existing, Section& section)
        : mesh_(mesh), crossings_(crossings), of_cut_point_(of_cut_point), of_existing_(of_existing), section_(section)
    {
        of_cut_point_.assign(crossings.cut_points.size(), kNone);
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
        std::uint32_t& number = of_existing_(point, point);
        if (number == kNone) number = add({position, point, kNone});
        return number;
    }

    std::uint32_t add(const SectionPoint& point)
    {
        section_.points.push_back(point);
        return static_cast<std::uint32_t>(section_.points.size() - 1);
    }

    const IndexedMesh& mesh_;
    Crossings& crossings_;
    std::vector<std::uint32_t>& of_cut_point_;
    PairTable& of_existing_;
    Section& section_;
};

/// The two vertices of an edge in the plane.
std::array<std::uint32_t, 2> ends_of(const IndexedMesh& mesh, const EdgeInPlane& edge)
{
    const Triangle& t = mesh.triangles[edge.triangle];
    return {t[edge.corner], t[(edge.corner + 1u) % 3]};
}

}  // namespace

void SectionFinder::find(const IndexedMesh& mesh, Crossings& crossings,
                         std::span<const EdgeInPlane> in_plane_of_negative,
                         std::span<const EdgeInPlane> in_plane_of_positive, Section& section)
{
    section.clear();
    section.points.reserve(crossings.cut_points.size());
    section.edges.reserve(crossings.triangles.size());
    // Room for all points that may be there already, both ends of each edge of chains that do not meet: a table that grows
    // takes memory.
    of_existing_.reset(2 * (crossings.triangles.size() + in_plane_of_positive.size()));
    PointNumbers numbers(mesh, crossings, of_cut_point_, of_existing_, section);

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
    pair_edges_in_plane(mesh, in_plane_of_negative, in_plane_of_positive);
    for (const auto& [edge, source, material] : in_plane_) {
        const auto [from, to] = ends_of(mesh, edge);
        section.edges.push_back({numbers.of_vertex(from), numbers.of_vertex(to), kNone, edge.triangle, edge.corner,
                                 static_cast<std::uint8_t>((edge.corner + 1u) % 3), mesh.groups[edge.group].solid,
                                 source, material});
    }
    cancel_opposite_edges(section);
}

/// Finds the edges in the plane that have a triangle of either side, as they run on the positive side. They are counted,
/// because pieces of earlier cuts can touch along an edge, so that more than two triangles meet there. Edges that run
/// forth and back on one side bound nothing there; each of the rest pairs with one reverse on the other side.
void SectionFinder::pair_edges_in_plane(const IndexedMesh& mesh, std::span<const EdgeInPlane> negative,
                                        std::span<const EdgeInPlane> positive)
{
    in_plane_.clear();
    if (negative.empty() || positive.empty()) return;
    row_at_.reset(negative.size() + positive.size());
    rows_.clear();
    std::int32_t direction = 0;
    for (const EdgeInPlane& edge : negative) {
        Row& row = row_of(mesh, edge, direction);
        row.below += direction;
        const std::uint32_t source = mesh.sources[edge.triangle];
        if (row.group_below != kNone && source >= row.source_below) continue;
        row.source_below = source;
        row.group_below = edge.group;
    }
    for (const EdgeInPlane& edge : positive) {
        Row& row = row_of(mesh, edge, direction);
        row.above += direction;
    }
    for (const EdgeInPlane& edge : positive) {
        Row& row = row_of(mesh, edge, direction);
        if (row.above * direction <= 0 || row.below * direction >= 0) continue;
        row.above -= direction;
        row.below += direction;
        in_plane_.push_back({edge, row.source, mesh.groups[row.group_below].material});
    }
}

/// `direction` is 1 of an edge that ascends, from the smaller point to the larger one, and otherwise -1.
SectionFinder::Row& SectionFinder::row_of(const IndexedMesh& mesh, const EdgeInPlane& edge, std::int32_t& direction)
{
    const auto [a, b] = ends_of(mesh, edge);
    const std::uint32_t p = mesh.points[a], q = mesh.points[b];
    direction = p < q ? 1 : -1;
    std::uint32_t& index = row_at_(std::min(p, q), std::max(p, q));
    if (index == kNone) {
        index = static_cast<std::uint32_t>(rows_.size());
        rows_.emplace_back();
    }
    Row& row = rows_[index];
    row.source = std::min(row.source, mesh.sources[edge.triangle]);
    return row;
}

/// Removes pairs of opposite edges, wherever they were found.
void SectionFinder::cancel_opposite_edges(Section& section)
{
    list_outline(section, outline_);
    for (const auto& pair : opposite_.find(section.points.size(), outline_)) {
        section.has_cancelled_edges = true;
        for (const std::uint32_t edge : pair) section.edges[edge].from = kNone;
    }
    std::erase_if(section.edges, [](const SectionEdge& edge) { return edge.from == kNone; });
}

Section find_section(const IndexedMesh& mesh, Crossings& crossings, std::span<const EdgeInPlane> in_plane_of_negative,
                     std::span<const EdgeInPlane> in_plane_of_positive)
{
    Section section;
    SectionFinder().find(mesh, crossings, in_plane_of_negative, in_plane_of_positive, section);
    return section;
}

void list_outline(const Section& section, std::vector<OutlineEdge>& outline)
{
    outline.clear();
    outline.reserve(section.edges.size());
    for (const SectionEdge& edge : section.edges) outline.push_back({edge.from, edge.to, {}, edge.source});
}

std::vector<OutlineEdge> outline_of(const Section& section)
{
    std::vector<OutlineEdge> outline;
    list_outline(section, outline);
    return outline;
}

void list_positions(const Section& section, std::vector<glm::vec3>& positions)
{
    positions.clear();
    positions.reserve(section.points.size());
    for (const SectionPoint& point : section.points) positions.push_back(point.position);
}

std::vector<glm::vec3> positions_of(const Section& section)
{
    std::vector<glm::vec3> positions;
    list_positions(section, positions);
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
