#include "bench/timed_cuts.h"

#include <kerf/proxy.h>

#include <array>

#include "bench/checked_cut.h"
#include "bench/objects.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

/// What is cut.
struct Prepared
{
    std::string key;
    Object object;
    CutCounts counted;  ///< by one cut with each plane: the same on every run, however often is timed
    std::string error;  ///< why a cut of it must not be timed
};

/// A mesh made ready and every cut of it that will be timed checked; kept for the repetitions and for the other extent.
const Prepared& prepared_and_checked(const TimedBackEnd& back_end, const Mesh& mesh, const std::string& name,
                                     std::span<const Plane> planes)
{
    static Prepared last;
    const std::string key = back_end.name + "/" + name + "/" + std::to_string(mesh.triangle_count());
    if (last.key == key) return last;
    last = {};
    Result<Object> result = back_end.prepare(mesh);
    last.error = result.reason();
    for (const Plane& plane : planes)
        if (result && last.error.empty()) last.error = check_cut(*result, plane, &last.counted);
    last.object = *std::move(result);
    last.key = key;
    return last;
}

}  // namespace

void time_cuts(benchmark::State& state, const TimedBackEnd& back_end, const Mesh& mesh, const std::string& name,
               std::span<const Plane> planes, Extent extent)
{
    const Prepared& prepared = prepared_and_checked(back_end, mesh, name, planes);
    if (!prepared.error.empty()) return state.SkipWithError(prepared.error.c_str());

    std::uint64_t cuts = 0;
    double seconds = 0.0;
    std::uint64_t crossing = 0;
    std::array<double, kPhaseCount> phase_ms{};
    double mass_ms = 0.0, proxy_ms = 0.0, draw_ms = 0.0;
    DrawView view;
    const auto cut_once = [&](const Plane& plane) {
        Object fresh = clone_of(prepared.object);
        core::CpuStopwatch whole, part;
        Cut result = cut(std::move(fresh), plane);
        benchmark::DoNotOptimize(result);
        part.lap();
        if (extent == Extent::whole_chain) {
            for_each_piece(result, [](const Object& piece) { benchmark::DoNotOptimize(piece.mass_properties()); });
            mass_ms += part.lap() * 1e3;
            for_each_piece(result,
                           [](const Object& piece) { benchmark::DoNotOptimize(bounded_hull(piece)->points().data()); });
            proxy_ms += part.lap() * 1e3;
            for_each_piece(result, [&](const Object& piece) {
                benchmark::DoNotOptimize(piece.draw(view));
                benchmark::DoNotOptimize(view.ranges.data());
            });
            draw_ms += part.lap() * 1e3;
        }
        const double taken = whole.lap();
        ++cuts;
        crossing += result.statistics().crossing_triangles;
        for (std::size_t i = 0; i < kPhaseCount; ++i) phase_ms[i] += result.statistics().phase_ms[i];
        return taken;
    };
    for (auto _ : state) {
        double round = 0.0;
        for (const Plane& plane : planes) round += cut_once(plane);
        state.SetIterationTime(round);
        seconds += round;
    }
    const auto n = double(cuts), triangles = double(mesh.triangle_count());
    const CutStatistics& counted = prepared.counted.all;
    const auto counts = double(planes.size());
    state.counters["triangles"] = triangles;
    state.counters["cuts_each"] = counts;
    state.counters["crossing"] = double(counted.crossing_triangles) / counts;
    state.counters["ns_per_triangle"] = seconds * 1e9 / n / triangles;
    state.counters["ns_per_crossing"] = seconds * 1e9 / double(crossing);
    state.counters["touched"] = double(counted.triangles_touched) / counts;
    state.counters["nodes"] = double(counted.nodes_visited) / counts;
    state.counters["comparisons"] = double(prepared.counted.report.vertex_comparisons) / counts;
    state.counters["upload_bytes"] = double(counted.bytes_to_upload) / counts;
    for (std::size_t i = 0; i < kPhaseCount; ++i)
        if (phase_ms[i] > 0) state.counters["ms_" + std::string(text(static_cast<Phase>(i)))] = phase_ms[i] / n;
    if (extent == Extent::whole_chain) {
        state.counters["ms_mass"] = mass_ms / n;
        state.counters["ms_proxy"] = proxy_ms / n;
        state.counters["ms_draw"] = draw_ms / n;
    }
}

}  // namespace kerf::bench
