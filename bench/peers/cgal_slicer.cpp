#include "bench/peers/cgal_slicer.h"

#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_slicer.h>

#include <cmath>
#include <iterator>
#include <vector>

#include "bench/peers/cgal_mesh.h"
#include "bench/peers/timed_planes.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

using Primitive = CGAL::AABB_halfedge_graph_segment_primitive<CgalMesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<CgalKernel, Primitive>>;
using Polyline = std::vector<CgalKernel::Point_3>;

Problem problem_of(const std::vector<Polyline>& lines, const SectionInput::Expected& expected)
{
    double length = 0.0;
    for (const Polyline& line : lines) {
        if (line.front() != line.back()) return "not closed";
        for (std::size_t i = 1; i < line.size(); ++i) length += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
    }
    if (lines.size() != expected.loops) return "other loops";
    if (!(std::abs(length - expected.length) <= kLengthShare * expected.length)) return "wrong length";
    return {};
}

}  // namespace

SlicerRow time_cgal_slicer(const SectionInput& input, double budget_seconds)
{
    const CgalMesh mesh = to_cgal(input);
    core::CpuStopwatch watch;
    Tree tree(edges(mesh).first, edges(mesh).second, mesh);
    tree.build();
    SlicerRow result;
    result.prepare_ms = watch.lap() * 1e3;
    const CGAL::Polygon_mesh_slicer<CgalMesh, CgalKernel> slicer(mesh, tree);
    result.row = time_planes(input.planes.size(), budget_seconds, [&](std::size_t i) -> std::pair<double, Problem> {
        std::vector<Polyline> lines;
        core::CpuStopwatch of_plane;
        slicer(to_cgal(input.planes[i]), std::back_inserter(lines));
        const double seconds = of_plane.lap();
        return {seconds, problem_of(lines, input.expected[i])};
    });
    result.row.peer = "cgal_slicer";
    result.row.mesh = input.name;
    result.row.triangles = input.triangles.size();
    return result;
}

}  // namespace kerf::bench
