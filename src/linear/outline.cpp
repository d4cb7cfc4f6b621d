#include "linear/outline.h"

#include <algorithm>
#include <memory>
#include <tuple>

#include "common/cutting/cut_geometry.h"
#include "common/cutting/section_ends.h"
#include "common/support/order_by.h"
#include "linear/section.h"
#include "linear/slices.h"
#include "linear/vertex_sides.h"

namespace kerf::core::linear {

namespace {

/// What a plane does to the triangles of a fragment. Keeps its memory.
class Sorting
{
public:
    void begin(const Fragment& whole, const Plane& plane)
    {
        mesh_ = &whole.mesh;
        plane_ = plane;
        crossings_.triangles.clear();
        for (const Side side : kSides) {
            edges_in_plane_[side].clear();
            keeps_[side] = false;
        }
        classes_.classify(whole, plane, [](std::uint32_t, std::uint8_t) {});
    }

    const VertexSides& classes() const { return classes_; }
    Crossings& crossings() { return crossings_; }
    std::span<const EdgeInPlane> edges_in_plane(Side side) const { return edges_in_plane_[side]; }

    /// Collects what crosses, and what lies in the plane, in the order in which a cut does.
    void sort_triangles()
    {
        order_by(order_, mesh_->groups.size(), [&](std::uint32_t g) {
            const TriangleGroup& group = mesh_->groups[g];
            return std::tie(group.kind, group.material, group.solid);
        });
        for (const std::uint32_t g : order_) {
            const TriangleGroup& group = mesh_->groups[g];
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
        const Triangle& t = mesh_->triangles[triangle];
        const std::uint8_t* const of = classes_.of_vertex.data();
        const auto joined = static_cast<std::uint8_t>(of[t[0]] | of[t[1]] | of[t[2]]);
        if (joined == kCrossing) {
            crossings_.triangles.push_back({triangle, group, 0, 0, {}});
            return;
        }
        Side side = joined == kBelow ? Side::negative : Side::positive;
        if (joined == kOn)
            side = coplanar_side(plane_, mesh_->vertices[t[0]].position, mesh_->vertices[t[1]].position,
                                 mesh_->vertices[t[2]].position);
        keeps_[side] = true;
        if (classes_.on == 0) return;
        for (std::uint8_t corner = 0; corner < 3; ++corner)
            if (of[t[corner]] == kOn && of[t[(corner + 1u) % 3]] == kOn)
                edges_in_plane_[side].push_back({triangle, group, corner});
    }

    const IndexedMesh* mesh_ = nullptr;
    Plane plane_;
    VertexSides classes_;
    Crossings crossings_;
    BySide<std::vector<EdgeInPlane>> edges_in_plane_;
    BySide<bool> keeps_{};
    std::vector<std::uint32_t> order_;
};

/// Finds outlines, and keeps its memory from one to the next.
class OutlineFinder final : public PlaneSection::Scratch
{
public:
    void find(const Fragment& whole, const Plane& plane, PlaneSection& section)
    {
        const IndexedMesh& mesh = whole.mesh;
        const auto misses = [&](Side side) { section.side_of_object = side; };
        if (const std::optional<Side> side = missed_by_bounds(whole, plane)) return misses(*side);
        section.triangles_touched = mesh.triangles.size();
        sorting_.begin(whole, plane);
        if (sorting_.classes().one_side_is_empty())
            return misses(sorting_.classes().far_above == 0 ? Side::negative : Side::positive);
        sorting_.sort_triangles();
        Crossings& crossings = sorting_.crossings();
        split_crossing_triangles(mesh, plane, crossings);
        // All of a side can vanish: a spike so thin that its cut points are one.
        for (const Side side : kSides)
            if (!sorting_.keeps_triangles(side)) return misses(opposite(side));

        finder_.find(mesh, crossings, sorting_.edges_in_plane(Side::negative), sorting_.edges_in_plane(Side::positive),
                     found_);
        const DividedOutline& divided = divide(plane);
        copy_paths(divided, section);
        if (section.wants_ends) add_ends(mesh, plane, divided, section);
        section.crossing_triangles = crossings.triangles.size();
        const bool closed = std::ranges::all_of(section.paths, &PlaneSection::Path::closed);
        section.status = closed ? Status::done : Status::open_section;
    }

private:
    const DividedOutline& divide(const Plane& plane)
    {
        solids_.clear();
        for (const SectionEdge& edge : found_.edges) solids_.push_back(edge.solid);
        list_outline(found_, outline_);
        list_positions(found_, positions_);
        return divider_.divide(plane, positions_, outline_, solids_);
    }

    void copy_paths(const DividedOutline& divided, PlaneSection& to) const
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

    void add_ends(const IndexedMesh& mesh, const Plane& plane, const DividedOutline& divided,
                  PlaneSection& section) const
    {
        for (std::size_t i = 0; i < section.paths.size(); ++i)
            section.for_each_edge(section.paths[i], [&](std::size_t e, const glm::vec3& p, const glm::vec3& q) {
                const SectionEdge& edge = found_.edges[divided.edges[divided.paths[i].first + e]];
                add_section_ends(plane, mesh.vertices, mesh.streams, mesh.triangles[edge.triangle], p, q, section);
            });
    }

    Sorting sorting_;
    SectionFinder finder_;
    Section found_;
    std::vector<std::uint64_t> solids_;
    std::vector<OutlineEdge> outline_;
    std::vector<glm::vec3> positions_;
    OutlineDivider divider_;
};

}  // namespace

void find_outline(const Fragment& whole, const Plane& plane, PlaneSection& section)
{
    auto* finder = dynamic_cast<OutlineFinder*>(section.scratch.get());
    if (finder == nullptr) {
        auto made = std::make_unique<OutlineFinder>();
        finder = made.get();
        section.scratch = std::move(made);
    }
    finder->find(whole, plane, section);
}

}  // namespace kerf::core::linear
