#include "bench/peers/cgal_slicer.h"

#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_slicer.h>

#include <cmath>
#include <iterator>
#include <utility>
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

std::vector<SlicerRow> time_cgal_slicer(const SectionInput& input, double budget_seconds)
{
    const CgalMesh mesh = to_cgal(input);
    core::CpuStopwatch watch;
    Tree tree(edges(mesh).first, edges(mesh).second, mesh);
    tree.build();
    const double prepare_ms = watch.lap() * 1e3;
    const CGAL::Polygon_mesh_slicer<CgalMesh, CgalKernel> slicer(mesh, tree);
    std::vector<SlicerRow> rows;
    const auto add = [&](std::size_t heights, PeerRow row) {
        row.peer = "cgal_slicer";
        row.mesh = input.name;
        row.triangles = input.triangles.size();
        rows.push_back({std::move(row), heights, prepare_ms});
    };
    add(1, time_planes(input.planes.size(), budget_seconds, [&](std::size_t i) -> std::pair<double, Problem> {
            std::vector<Polyline> lines;
            core::CpuStopwatch of_plane;
            slicer(to_cgal(input.planes[i]), std::back_inserter(lines));
            const double seconds = of_plane.lap();
            return {seconds, problem_of(lines, input.expected[i])};
        }));
    for (const SectionInput::Stack& stack : input.stacks)
        add(stack.heights.size(), time_planes(1, budget_seconds, [&](std::size_t) -> std::pair<double, Problem> {
                std::vector<Polyline> lines;
                core::CpuStopwatch of_stack;
                for (const double height : stack.heights) slicer(to_cgal(*Plane::z(height)), std::back_inserter(lines));
                const double seconds = of_stack.lap();
                return {seconds, problem_of(lines, stack.expected)};
            }));
    return rows;
}

}  // namespace kerf::bench
