#include "bench/peers/cgal_cells.h"

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <kerf/fracture.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "bench/objects.h"
#include "bench/peers/cgal_mesh.h"
#include "bench/peers/in_a_child.h"
#include "bench/peers/timed_planes.h"
#include "bench/timed_shapes.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

CgalKernel::Point_3 to_cgal_point(const Vec3d& p)
{
    return {p.x, p.y, p.z};
}

/// The cell of a site, or a part of the mesh that holds it, if all other sites are too far away to meet it.
CgalMesh cell_of(const CellInput& input, std::size_t site, CgalMesh mesh)
{
    const CgalKernel::Point_3 own = to_cgal_point(input.sites[site]);
    std::vector<std::size_t> others(input.sites.size());
    std::iota(others.begin(), others.end(), std::size_t{0});
    const auto distance = [&](std::size_t i) { return CGAL::squared_distance(own, to_cgal_point(input.sites[i])); };
    std::sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    for (const std::size_t other : others) {
        if (other == site) continue;
        double radius = 0.0;
        for (const auto vertex : mesh.vertices())
            radius = std::max(radius, CGAL::squared_distance(own, mesh.point(vertex)));
        if (distance(other) > 4.0 * radius) break;
        const CgalKernel::Point_3 theirs = to_cgal_point(input.sites[other]);
        const CgalKernel::Plane_3 plane(CGAL::midpoint(own, theirs), theirs - own);
        if (!PMP::clip(mesh, plane, CGAL::parameters::clip_volume(true))) throw std::runtime_error("gives up");
        mesh.collect_garbage();
    }
    return mesh;
}

/// Some cells come to no end: the others take a second or two.
constexpr int kMostSeconds = 10;

/// What came of one cell.
struct Cell
{
    double seconds, volume;
    bool is_given_up, is_closed;
};

Cell timed_cell(const CellInput& input, std::size_t site, const CgalMesh& whole)
{
    CgalMesh copy = whole;
    core::CpuStopwatch watch;
    try {
        const CgalMesh cell = cell_of(input, site, std::move(copy));
        const double seconds = watch.lap();
        const bool is_closed = CGAL::is_closed(cell);
        return {seconds, is_closed ? PMP::volume(cell) : 0.0, false, is_closed};
    } catch (const std::exception&) {
        return {watch.lap(), 0.0, true, false};
    }
}

}  // namespace

CellInput asteroid_cell_input(std::uint64_t triangles, std::uint32_t cells)
{
    const Mesh& mesh = timed_shape("asteroid", triangles);
    CellInput input;
    input.name = "asteroid";
    const MeshArrays arrays = mesh.arrays();
    input.points.resize(arrays.point_count);
    for (std::size_t v = 0; v < arrays.positions.size(); ++v) input.points[arrays.points[v]] = arrays.positions[v];
    for (std::size_t t = 0; t < arrays.sources.size(); ++t)
        input.triangles.push_back({arrays.points[arrays.indices[3 * t]], arrays.points[arrays.indices[3 * t + 1]],
                                   arrays.points[arrays.indices[3 * t + 2]]});
    PrepareOptions prepare_options;
    prepare_options.back_end = BackEnd::linear;
    const Object object = value_of(prepare(mesh, prepare_options));
    FractureOptions options;
    options.cells = cells;
    options.seed = 1;
    const Fracture fracture = kerf::fracture(object, options);
    input.sites.assign(fracture.sites().begin(), fracture.sites().end());
    input.volume = object.mass_properties().volume;
    return input;
}

PeerRow time_cgal_cells(const CellInput& input, double budget_seconds)
{
    const CgalMesh whole = to_cgal(input);
    double volume = 0.0;
    PeerRow row = time_planes(input.sites.size(), budget_seconds, [&](std::size_t i) -> std::pair<double, Problem> {
        const std::optional<Cell> cell = in_a_child(kMostSeconds, [&] { return timed_cell(input, i, whole); });
        if (!cell) return {0.0, "never ends"};
        volume += cell->volume;
        return {cell->seconds, cell->is_given_up ? "gives up" : cell->is_closed ? "" : "not closed"};
    });
    if (row.right == input.sites.size() && std::abs(volume - input.volume) > kVolumeShare * input.volume)
        row.verdict = "wrong volume";
    row.peer = "cgal_clip";
    row.mesh = input.name;
    row.triangles = input.triangles.size();
    return row;
}

}  // namespace kerf::bench
