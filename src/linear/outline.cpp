#include "linear/outline.h"

#include <algorithm>
#include <memory>
#include <tuple>

#include "common/cutting/section_ends.h"
#include "common/support/order_by.h"
#include "linear/slices.h"

namespace kerf::core::linear {

void SortedTriangles::clear()
{
    crossings.triangles.clear();
    for (const Side side : kSides) {
        edges_in_plane[side].clear();
        keeps[side] = false;
    }
}

void order_groups(const IndexedMesh& mesh, std::vector<std::uint32_t>& order)
{
    order_by(order, mesh.groups.size(), [&](std::uint32_t g) {
        const TriangleGroup& group = mesh.groups[g];
        return std::tie(group.kind, group.material, group.solid);
    });
}

OutlineFinder& OutlineFinder::of(PlaneSection& section)
{
    if (auto* finder = dynamic_cast<OutlineFinder*>(section.scratch.get())) return *finder;
    auto made = std::make_unique<OutlineFinder>();
    OutlineFinder& finder = *made;
    section.scratch = std::move(made);
    return finder;
}

void OutlineFinder::finish(const IndexedMesh& mesh, const Plane& plane, PlaneSection& section)
{
    Crossings& crossings = sorted_.crossings;
    split_crossing_triangles(mesh, plane, crossings);
    // All of a side can vanish: a spike so thin that its cut points are one.
    for (const Side side : kSides) {
        const bool keeps =
            sorted_.keeps[side] || std::ranges::any_of(crossings.triangles, [&](const CrossingTriangle& c) {
                return std::ranges::any_of(c.split.sub_triangles(),
                                           [&](const SubTriangle& t) { return t.side == side; });
            });
        if (keeps) continue;
        section.side_of_object = opposite(side);
        return;
    }
    finder_.find(mesh, crossings, sorted_.edges_in_plane[Side::negative], sorted_.edges_in_plane[Side::positive],
                 found_);
    const DividedOutline& divided = divide(plane);
    copy_paths(divided, section);
    if (section.wants_ends) add_ends(mesh, plane, divided, section);
    section.crossing_triangles = crossings.triangles.size();
    const bool closed = std::ranges::all_of(section.paths, &PlaneSection::Path::closed);
    section.status = closed ? Status::done : Status::open_section;
}

const DividedOutline& OutlineFinder::divide(const Plane& plane)
{
    solids_.clear();
    for (const SectionEdge& edge : found_.edges) solids_.push_back(edge.solid);
    list_outline(found_, outline_);
    list_positions(found_, positions_);
    return divider_.divide(plane, positions_, outline_, solids_);
}

void OutlineFinder::copy_paths(const DividedOutline& divided, PlaneSection& to) const
{
    for (const OutlinePath& path : divided.paths) {
        const auto edge = [&](std::size_t i) -> const SectionEdge& {
            return found_.edges[divided.edges[path.first + i]];
        };
        to.paths.push_back({to.points.size(), path.count + (path.closed ? 0 : 1), to.edges.size(), path.count,
                            edge(0).solid, path.closed});
        for (std::size_t i = 0; i < path.count; ++i) {
            to.points.push_back(positions_[edge(i).from]);
            to.edges.push_back({edge(i).source, edge(i).material});
        }
        if (!path.closed) to.points.push_back(positions_[edge(path.count - 1).to]);
    }
}

void OutlineFinder::add_ends(const IndexedMesh& mesh, const Plane& plane, const DividedOutline& divided,
                             PlaneSection& section) const
{
    for (std::size_t i = 0; i < section.paths.size(); ++i)
        section.for_each_edge(section.paths[i], [&](std::size_t e, const glm::vec3& p, const glm::vec3& q) {
            const SectionEdge& edge = found_.edges[divided.edges[divided.paths[i].first + e]];
            add_section_ends(plane, mesh.vertices, mesh.streams, mesh.triangles[edge.triangle], p, q, section);
        });
}

void find_outline(const Fragment& whole, const Plane& plane, PlaneSection& section)
{
    const IndexedMesh& mesh = whole.mesh;
    const auto misses = [&](Side side) { section.side_of_object = side; };
    if (const std::optional<Side> side = missed_by_bounds(whole, plane)) return misses(*side);
    OutlineFinder& finder = OutlineFinder::of(section);
    section.triangles_touched = mesh.triangles.size();
    VertexSides& classes = finder.classes();
    classes.classify(whole, plane, [](std::uint32_t, std::uint8_t) {});
    if (classes.one_side_is_empty()) return misses(classes.far_above == 0 ? Side::negative : Side::positive);
    SortedTriangles& sorted = finder.sorted();
    sorted.clear();
    std::vector<std::uint32_t>& order = finder.group_order();
    order_groups(mesh, order);
    const std::uint8_t* const of = classes.of_vertex.data();
    for (const std::uint32_t g : order)
        for (std::uint32_t i = mesh.groups[g].first; i < mesh.groups[g].first + mesh.groups[g].count; ++i)
            sorted.add(mesh, plane, i, g, [&](std::uint32_t v) { return of[v]; });
    finder.finish(mesh, plane, section);
}

}  // namespace kerf::core::linear
