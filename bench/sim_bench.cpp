// What the viewer's simulation costs on the processor:
//   Swipe/<back end>/asteroid/<triangles>  from the hit of a swipe to the last rigid body: cut, mass properties,
//                                          bounded hulls, bodies, momentum (drawing and uploads are measured by
//                                          kerf-viewer)
//   Pieces/<spread|heap>/<count>           two ticks of 1/120 s, a frame's physics: pieces in flight, and pieces that
//                                          all lie in one another because they were cut within a quarter of a second
//   Physics/<proxy>/<count>                the same for pieces in flight, with each kind of collision proxy

#include <benchmark/benchmark.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <string>

#include "bench/timed_shapes.h"
#include "common/support/cpu_stopwatch.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/body_proxies.h"
#include "viewer/sim/simulation.h"

namespace kerf::bench {
namespace {

constexpr sim::Tick kNearApex = 85;
constexpr std::uint64_t kSeed = 99;

/// A library with one asteroid, kept for repetitions: preparing is not what is timed.
std::shared_ptr<sim::ModelLibrary> asteroid_library(std::uint64_t triangles)
{
    static std::uint64_t size = 0;
    static std::shared_ptr<sim::ModelLibrary> library;
    if (size != triangles) {
        library = std::make_shared<sim::ModelLibrary>();
        library->add("asteroid", timed_shape("asteroid", triangles));
        size = triangles;
    }
    return library;
}

/// A quick stroke through where a body is seen, along an angle.
void stroke(sim::Simulation& run, const sim::Body& body, double angle, double half_length)
{
    const glm::dvec3 c = body.centre();
    const glm::dvec2 seen = glm::dvec2(c) * (sim::kEyeDistance / (sim::kEyeDistance - c.z));
    const glm::dvec2 along = half_length * glm::dvec2(std::cos(angle), std::sin(angle));
    const sim::Microseconds now = run.time() + 1;
    run.push({now, sim::InputKind::press, seen - along, {}});
    run.push({now + 2000, sim::InputKind::release, seen + along, {}});
    run.advance();
}

void swipe(benchmark::State& state, const std::string& backend, std::uint64_t triangles)
{
    const auto library = asteroid_library(triangles);
    double crossing = 0.0, bytes = 0.0, cuts = 0.0;
    std::uint64_t seed = kSeed;
    for (auto _ : state) {
        sim::Settings settings;
        settings.backend = backend;
        settings.seed = ++seed;
        sim::Simulation run(library, settings);
        run.advance(kNearApex);
        stroke(run, *run.bodies().front(), double(seed), 2.0);
        if (run.cuts().empty() || run.cuts().front().status != Status::done)
            return state.SkipWithError("the swipe cut nothing");
        const sim::CutRecord& cut = run.cuts().front();
        state.SetIterationTime(cut.cpu_ms * 1e-3);
        crossing += double(cut.statistics.crossing_triangles);
        bytes += double(cut.statistics.bytes_to_upload);
        cuts += 1.0;
    }
    state.counters["crossing"] = crossing / cuts;
    state.counters["bytes_to_upload"] = bytes / cuts;
}

/// Cuts pieces in turn until there are as many as wanted; `ticks_between` strokes they fly on.
bool cut_up(sim::Simulation& run, std::size_t count, sim::Tick ticks_between)
{
    for (int strokes = 0; run.bodies().size() < count; ++strokes) {
        if (strokes == 1000 || run.bodies().empty()) return false;
        const sim::Body& target = *run.bodies()[std::size_t(strokes) * 7 % run.bodies().size()];
        stroke(run, target, 2.4 * strokes, 7.0);
        run.advance(ticks_between);
    }
    return true;
}

void pieces(benchmark::State& state, bool heap, sim::ProxyKind proxy)
{
    const auto wanted = std::size_t(state.range(0));
    sim::Settings settings;
    settings.proxy = proxy;
    sim::Simulation run(asteroid_library(5000), settings);
    // In a heap ten asteroids are cut within a moment; spread, many more are thrown and cut rarely.
    for (int i = 0; i < (heap ? 10 : 40); ++i) run.command("throw");
    run.advance(heap ? 70 : 60);
    if (!cut_up(run, wanted, heap ? 0 : 3)) return state.SkipWithError("there are not enough pieces");
    double touching = 0.0, bodies = 0.0, frames = 0.0;
    for (auto _ : state) {
        core::CpuStopwatch watch;
        run.advance(sim::kTicksPerFrame);
        state.SetIterationTime(watch.lap());
        touching += double(run.world().contacts());
        bodies += double(run.bodies().size());
        frames += 1.0;
    }
    state.counters["bodies"] = bodies / frames;
    state.counters["touching_pairs"] = touching / frames;
}

}  // namespace

void register_sim_benchmarks()
{
    for (const std::uint64_t triangles : {10'000u, 100'000u, 1'000'000u})
        for (const std::string& backend : sim::backend_names()) {
            const bool quadratic = backend == "baseline/scan" || backend == "baseline/two_bucket_hash";
            if (quadratic && triangles > 10'000) continue;
            if (backend == "halfedge/cgal") continue;  // differs in caps only
            benchmark::RegisterBenchmark(("Swipe/" + backend + "/asteroid/" + std::to_string(triangles)).c_str(),
                                         [=](benchmark::State& state) { swipe(state, backend, triangles); })
                ->UseManualTime()
                ->Iterations(quadratic ? 3 : 20)
                ->Unit(benchmark::kMillisecond);
        }
    for (const bool heap : {false, true})
        benchmark::RegisterBenchmark(
            heap ? "Pieces/heap" : "Pieces/spread",
            [=](benchmark::State& state) { pieces(state, heap, sim::ProxyKind::bounded_hull); })
            ->Arg(300)
            ->UseManualTime()
            ->Iterations(20)
            ->Unit(benchmark::kMillisecond);
    for (const sim::ProxyKind proxy : sim::kProxyKinds)
        benchmark::RegisterBenchmark(("Physics/" + std::string(sim::proxy_name(proxy))).c_str(),
                                     [=](benchmark::State& state) { pieces(state, false, proxy); })
            ->Arg(300)
            ->UseManualTime()
            ->Iterations(20)
            ->Unit(benchmark::kMillisecond);
}

}  // namespace kerf::bench
