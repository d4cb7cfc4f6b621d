#include "bench/peers/cgal_peer.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>

#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

CgalMesh to_cgal(const PeerInput& input)
{
    CgalMesh mesh;
    std::vector<CgalMesh::Vertex_index> points;
    for (const Vec3f& p : input.points) points.push_back(mesh.add_vertex({p.x, p.y, p.z}));
    for (const auto& t : input.triangles) mesh.add_face(points[t[0]], points[t[1]], points[t[2]]);
    return mesh;
}

Kernel::Plane_3 to_cgal(const Plane& plane)
{
    const Normal normal = plane.normal();
    return {normal.x, normal.y, normal.z, -plane.offset()};
}

/// What is the matter with one cut; empty when nothing is.
using Problem = std::string;

/// Cuts by every plane, or until the budget is spent: `cut_once` gives seconds and the matter.
template <class CutOnce>
PeerRow time_planes(const std::string& peer, const PeerInput& input, double budget_seconds, CutOnce cut_once)
{
    PeerRow row;
    row.peer = peer;
    row.mesh = input.name;
    row.triangles = input.triangles.size();
    std::map<Problem, std::size_t> problems;
    double seconds = 0.0;
    for (std::size_t i = 0; i < input.planes.size() && (i == 0 || seconds < budget_seconds); ++i) {
        const auto [taken, problem] = cut_once(i);
        seconds += taken;
        row.least_ms = i == 0 ? taken * 1e3 : std::min(row.least_ms, taken * 1e3);
        row.most_ms = std::max(row.most_ms, taken * 1e3);
        ++row.planes;
        if (problem.empty())
            ++row.right;
        else
            ++problems[problem];
    }
    row.ms = seconds * 1e3 / double(row.planes);
    for (const auto& [problem, count] : problems)
        row.verdict +=
            (row.verdict.empty() ? "" : "; ") + problem + (count == row.planes ? "" : " in " + std::to_string(count));
    if (row.verdict.empty()) row.verdict = "right";
    return row;
}

}  // namespace

PeerRow time_cgal_clip(const PeerInput& input, double budget_seconds)
{
    const CgalMesh whole = to_cgal(input);
    return time_planes("cgal_clip", input, budget_seconds, [&](std::size_t i) -> std::pair<double, Problem> {
        CgalMesh negative = whole, positive = whole;
        const Kernel::Plane_3 plane = to_cgal(input.planes[i]);
        core::CpuStopwatch watch;
        try {
            const bool done = PMP::clip(negative, plane, CGAL::parameters::clip_volume(true)) &&
                              PMP::clip(positive, plane.opposite(), CGAL::parameters::clip_volume(true));
            const double seconds = watch.lap();
            if (!done || !CGAL::is_closed(negative) || !CGAL::is_closed(positive)) return {seconds, "not closed"};
            const double allowed = kVolumeShare * std::abs(input.volume);
            const double below = PMP::volume(negative), above = PMP::volume(positive);
            if (!(std::abs(below - input.volumes[i]) <= allowed) ||
                !(std::abs(below + above - input.volume) <= allowed))
                return {seconds, "wrong volume"};
            return {seconds, {}};
        } catch (const std::exception&) {
            return {watch.lap(), "gives up"};
        }
    });
}

PeerRow time_cgal_split(const PeerInput& input, double budget_seconds)
{
    const CgalMesh whole = to_cgal(input);
    const double area = PMP::area(whole);
    return time_planes("cgal_split", input, budget_seconds, [&](std::size_t i) -> std::pair<double, Problem> {
        CgalMesh mesh = whole;
        core::CpuStopwatch watch;
        try {
            PMP::split(mesh, to_cgal(input.planes[i]));
            const double seconds = watch.lap();
            if (!(std::abs(PMP::area(mesh) - area) <= kVolumeShare * area)) return {seconds, "wrong area"};
            return {seconds, "makes no caps"};
        } catch (const std::exception&) {
            return {watch.lap(), "gives up"};
        }
    });
}

}  // namespace kerf::bench
