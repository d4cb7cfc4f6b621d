#include "common/fracture/split_into_cells.h"

#include <utility>

namespace kerf::core {

std::optional<SplitSolid> split_into_cells(std::span<const glm::vec3> points, std::span<const PointTriple> triangles,
                                           std::span<const glm::dvec3> sites, const ProgressOfStep& progress)
{
    Box bounds;
    for (const glm::vec3& point : points) bounds.add(point);
    const std::optional<CellDiagram> diagram = make_cell_diagram(sites, bounds, progress.part(0.0, 0.2));
    return diagram ? split_into_cells(points, triangles, *diagram, progress.part(0.2, 1.0)) : std::nullopt;
}

std::optional<SplitSolid> split_into_cells(std::span<const glm::vec3> points, std::span<const PointTriple> triangles,
                                           const CellDiagram& diagram, const ProgressOfStep& progress)
{
    DividedSurface surface = divide_surface(points, triangles, diagram, progress.part(0.0, 0.5));
    progress.at(0.5);
    const auto edges = find_inside_edges(diagram, points, surface);
    if (!edges) return std::nullopt;
    auto contacts = close_contacts(diagram, points, *edges, surface, progress.part(0.6, 1.0));
    if (!contacts) return std::nullopt;
    return SplitSolid{std::move(surface.new_points), std::move(surface.places), std::move(surface.parts),
                      *std::move(contacts), surface.crossing_triangles};
}

}  // namespace kerf::core
