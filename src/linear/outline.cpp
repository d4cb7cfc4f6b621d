#include "linear/outline.h"

#include <algorithm>
#include <tuple>

#include "common/cutting/cut_geometry.h"
#include "common/support/order_by.h"
#include "linear/section.h"
#include "linear/slices.h"
#include "linear/vertex_sides.h"

namespace kerf::core::linear {

namespace {

/// What a plane does to the triangles of a fragment.
class Sorting
{
public:
    Sorting(const Fragment& whole, const Plane& plane) : mesh_(whole.mesh), plane_(plane)
    {
        classes_.classify(whole, plane, [](std::uint32_t, std::uint8_t) {});
    }

    const VertexSides& classes() const { return classes_; }
    Crossings& crossings() { return crossings_; }
    std::span<const EdgeInPlane> edges_in_plane(Side side) const { return edges_in_plane_[side]; }

    /// Collects what crosses, and what lies in the plane, in the order in which a cut does.
    void sort_triangles()
    {
        std::vector<std::uint32_t> order;
        order_by(order, mesh_.groups.size(), [&](std::uint32_t g) {
            const TriangleGroup& group = mesh_.groups[g];
            return std::tie(group.kind, group.material, group.solid);
        });
        for (const std::uint32_t g : order) {
            const TriangleGroup& group = mesh_.groups[g];
            for (std::uint32_t i = group.first; i < group.first + group.count; ++i) sort(i, g);
        }
    }

    /// Whether a side gets any triangle, once the crossing triangles are split.
    bool keeps_triangles(Side side) const
    {
        return keeps_[side] || std::ranges::any_of(crossings_.triangles, [&](const CrossingTriangle& c) {
                   return std::ranges::any_of(c.split.sub_triangles(),
                                              [&](const SubTriangle& t) { return t.side == side; });
               });
    }

private:
    void sort(std::uint32_t triangle, std::uint32_t group)
    {
        const Triangle& t = mesh_.triangles[triangle];
        const std::uint8_t* const of = classes_.of_vertex.data();
        const auto joined = static_cast<std::uint8_t>(of[t[0]] | of[t[1]] | of[t[2]]);
        if (joined == kCrossing) {
            crossings_.triangles.push_back({triangle, group, 0, 0, {}});
            return;
        }
        Side side = joined == kBelow ? Side::negative : Side::positive;
        if (joined == kOn)
            side = coplanar_side(plane_, mesh_.vertices[t[0]].position, mesh_.vertices[t[1]].position,
                                 mesh_.vertices[t[2]].position);
        keeps_[side] = true;
        if (classes_.on == 0) return;
        for (std::uint8_t corner = 0; corner < 3; ++corner)
            if (of[t[corner]] == kOn && of[t[(corner + 1u) % 3]] == kOn)
                edges_in_plane_[side].push_back({triangle, group, corner});
    }

    const IndexedMesh& mesh_;
    const Plane& plane_;
    VertexSides classes_;
    Crossings crossings_;
    BySide<std::vector<EdgeInPlane>> edges_in_plane_;
    BySide<bool> keeps_{};
};

void copy_path(const Section& from, const SectionPath& path, PlaneSection& to)
{
    const std::size_t count = path.edges.size();
    to.paths.push_back({to.points.size(), count + (path.closed ? 0 : 1), to.edges.size(), count,
                        from.edges[path.edges.front()].solid, path.closed});
    for (const std::uint32_t e : path.edges) {
        const SectionEdge& edge = from.edges[e];
        to.points.push_back(from.points[edge.from].position);
        to.edges.push_back({edge.source, edge.material});
    }
    if (!path.closed) to.points.push_back(from.points[from.edges[path.edges.back()].to].position);
}

}  // namespace

void find_outline(const Fragment& whole, const Plane& plane, PlaneSection& section)
{
    const IndexedMesh& mesh = whole.mesh;
    const auto misses = [&](Side side) { section.side_of_object = side; };
    if (const std::optional<Side> side = missed_by_bounds(whole, plane)) return misses(*side);
    section.triangles_touched = mesh.triangles.size();
    Sorting sorting(whole, plane);
    if (sorting.classes().one_side_is_empty())
        return misses(sorting.classes().far_above == 0 ? Side::negative : Side::positive);
    sorting.sort_triangles();
    Crossings& crossings = sorting.crossings();
    split_crossing_triangles(mesh, plane, crossings);
    // All of a side can vanish: a spike so thin that its cut points are one.
    for (const Side side : kSides)
        if (!sorting.keeps_triangles(side)) return misses(opposite(side));

    const Section found =
        find_section(mesh, crossings, sorting.edges_in_plane(Side::negative), sorting.edges_in_plane(Side::positive));
    std::vector<std::uint64_t> solids;
    solids.reserve(found.edges.size());
    for (const SectionEdge& edge : found.edges) solids.push_back(edge.solid);
    const std::vector<SectionPath> paths = link_paths(plane, found, solids);
    for (const SectionPath& path : paths) copy_path(found, path, section);
    section.area = area_of(found, paths, plane);
    section.crossing_triangles = crossings.triangles.size();
    const bool closed = std::ranges::all_of(paths, &SectionPath::closed);
    section.status = closed ? Status::done : Status::open_section;
}

}  // namespace kerf::core::linear
