#include "linear/right_caps.h"

#include <unordered_map>

#include <glm/geometric.hpp>

#include "common/cutting/back_end_helpers.h"
#include "common/geometry/disjoint_sets.h"
#include "common/mesh/plane_frame.h"
#include "common/support/order_by.h"
#include "linear/split_points.h"

namespace kerf::core::linear {

void RightCaps::collect_loops(const LinkedSection& linked)
{
    loops_.clear();
    path_of_set_.clear();
    points_.clear();
    edge_at_.clear();
    next_.clear();
    std::unordered_map<std::uint64_t, Index> set_of_tag;
    for (std::uint32_t p = 0; p < linked.paths.size(); ++p) {
        const SectionPath& path = linked.paths[p];
        if (!path.closed) continue;
        const auto [entry, is_new] =
            set_of_tag.try_emplace(linked.tags[path.edges.front()], static_cast<Index>(path_of_set_.size()));
        if (is_new) path_of_set_.push_back(p);
        const std::size_t first = points_.size();
        loops_.push_back({first, path.edges.size(), entry->second});
        for (const std::uint32_t e : path.edges) {
            points_.push_back(linked.section.points[linked.section.edges[e].from].position);
            edge_at_.push_back(e);
            next_.push_back(static_cast<Index>(points_.size()));
        }
        if (points_.size() > first) next_.back() = static_cast<Index>(first);
    }
}

bool RightCaps::is_regular(const Crossings& crossings, const LinkedSection& linked) const
{
    if (linked.section.has_cancelled_edges || !crossings.cut_points.joined().empty()) return false;
    if (!caps_.cancelled.empty() || !caps_.shared_points.empty()) return false;
    // A cut point is passed once, if it fell on nothing: each of its two triangles has one edge of the section.
    std::vector<bool> is_passed(linked.section.points.size(), false);
    for (const SectionEdge& edge : linked.section.edges) {
        const SectionPoint &from = linked.section.points[edge.from], &to = linked.section.points[edge.to];
        if (from.existing != kNone || to.existing != kNone || is_passed[edge.from]) return false;
        is_passed[edge.from] = true;
    }
    return std::none_of(crossings.triangles.begin(), crossings.triangles.end(), [](const CrossingTriangle& c) {
        return c.split.next_code != TriangleSplit::kCutNext || c.split.previous_code != TriangleSplit::kCutPrevious;
    });
}

ClosedSides RightCaps::close(BySide<SideBuilder>& builders, Crossings& crossings, const LinkedSection& linked)
{
    collect_loops(linked);
    caps_.clear();
    if (linked.with_caps) closer_.close(linked.plane, loops_, linked.quality, points_, caps_);
    for (const Index edge : caps_.crossing_edges) edge_at_.push_back(edge_at_[edge]);
    is_regular_ = is_regular(crossings, linked);

    if (!linked.with_caps) return {};
    ClosedSides closed;
    closed.steps = closer_.steps();
    if (closer_.excess() > 0.0) {
        double length = 0.0;
        for (std::size_t i = 0; i < next_.size(); ++i)
            length += glm::distance(glm::dvec3(points_[i]), glm::dvec3(points_[next_[i]]));
        closed.caps_exceed_section = caps_exceed_section(closer_.excess(), linked.area, length, linked.unit);
    }
    for (SideBuilder& builder : builders) append_caps(builder, crossings, linked, closed.path_of_cap[builder.side()]);
    return closed;
}

void RightCaps::append_caps(SideBuilder& builder, Crossings& crossings, const LinkedSection& linked,
                            std::vector<std::uint32_t>& path_of_cap)
{
    IndexedMesh& mesh = builder.mesh;
    const PlaneFrame frame = PlaneFrame::of(linked.plane.normal, linked.uv_scale);
    const glm::vec3 normal(builder.side() == Side::negative ? linked.plane.normal : -linked.plane.normal);
    const auto first_vertex = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        // What the surface has where the edge starts.
        const SectionEdge& edge = linked.section.edges[edge_at_[i]];
        if (edge.crossing != kNone)
            builder.append_streams(crossings.triangles[edge.crossing], edge.from_corner);
        else
            builder.append_streams_of(builder.source().triangles[edge.triangle][edge.from_corner]);
        const SectionPoint& point = linked.section.points[edge.from];
        if (i >= next_.size())
            mesh.points.push_back(builder.new_point());
        else
            mesh.points.push_back(point.existing != kNone ? builder.point_of_existing(point.existing)
                                                          : builder.point_of_cut(crossings, point.cut_point));
        builder.append_vertex({points_[i], normal, frame.uv(points_[i])});
    }

    const auto solid_of = [&](const CapSet& set) {
        return linked.section.edges[linked.paths[path_of_set_[set.set]].edges.front()].solid;
    };
    std::vector<std::uint32_t> sets;
    order_by(sets, caps_.sets.size(), [&](std::uint32_t set) { return solid_of(caps_.sets[set]); });
    for (const std::uint32_t s : sets) {
        const CapSet& set = caps_.sets[s];
        for (std::size_t i = set.first; i < set.first + set.count; ++i) {
            const auto& [a, b, c] = caps_.triangles[caps_.order[i]].corner;
            if (builder.side() == Side::negative)
                builder.add_triangle({first_vertex + a, first_vertex + b, first_vertex + c}, kNoSource);
            else
                builder.add_triangle({first_vertex + a, first_vertex + c, first_vertex + b}, kNoSource);
        }
        path_of_cap.insert(path_of_cap.end(), set.count, path_of_set_[set.set]);
        builder.close_group({0, 0, linked.material, solid_of(set), TriangleKind::cap});
    }
    if (!is_regular_) unite_points(builder, first_vertex);
}

void RightCaps::unite_points(SideBuilder& builder, std::uint32_t first_vertex) const
{
    IndexedMesh& mesh = builder.mesh;
    DisjointSets joined(mesh.point_count);
    const auto unite = [&](Index a, Index b) {
        joined.unite(mesh.points[first_vertex + a], mesh.points[first_vertex + b]);
    };
    for (const CapTriangle& t : caps_.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const CapLink link = t.link[i];
            const Index from = t.corner[i], to = t.corner[(i + 1) % 3];
            if (link.is_outline()) {
                unite(from, link.outline_edge());
                unite(to, next_[link.outline_edge()]);
            } else {
                const CapTriangle& across = caps_.triangles[link.triangle()];
                unite(from, across.corner[(link.corner() + 1) % 3]);
                unite(to, across.corner[link.corner()]);
            }
        }
    for (const auto& [a, b] : caps_.cancelled) {
        unite(a, next_[b]);
        unite(next_[a], b);
    }
    for (std::uint32_t& point : mesh.points) point = joined.find(point);
}

void RightCaps::finish(Fragment& fragment, const Plane& plane)
{
    if (!is_regular_) split_points(fragment.mesh, plane, fragment.noise);
}

}  // namespace kerf::core::linear
