#include "bench/peers/cgal_peer.h"

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cmath>
#include <exception>

#include "bench/peers/cgal_mesh.h"
#include "bench/peers/timed_planes.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

/// Cuts by every plane, or until the budget is spent: `cut_once` gives seconds and the matter.
template <class CutOnce>
PeerRow time_cuts_of(const std::string& peer, const PeerInput& input, double budget_seconds, CutOnce cut_once)
{
    PeerRow row = time_planes(input.planes.size(), budget_seconds, cut_once);
    row.peer = peer;
    row.mesh = input.name;
    row.triangles = input.triangles.size();
    return row;
}

}  // namespace

PeerRow time_cgal_clip(const PeerInput& input, double budget_seconds)
{
    const CgalMesh whole = to_cgal(input);
    return time_cuts_of("cgal_clip", input, budget_seconds, [&](std::size_t i) -> std::pair<double, Problem> {
        CgalMesh negative = whole, positive = whole;
        const CgalKernel::Plane_3 plane = to_cgal(input.planes[i]);
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
    return time_cuts_of("cgal_split", input, budget_seconds, [&](std::size_t i) -> std::pair<double, Problem> {
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
