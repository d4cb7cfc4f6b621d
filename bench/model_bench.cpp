// The report's fifteen models, ten cuts each (its Table 2):
//   Cut/<back end>/<model>        one cut, fan and new pivots included, as the report times it
//   Proxy/<kind>/<model>          the collision proxies of both fragments of a cut, linear back end
//   Proxy/halfedge/<kind>/<model> the hulls of the same fragments, half-edge back end
//   Prepare/<back end>/<model>    making a mesh ready for cutting
// Loading, cloning and destroying stay untimed.

#include <benchmark/benchmark.h>

#include <algorithm>

#include "baseline/baseline.h"
#include "baseline/report_proxy/every_vertex.h"
#include "bench/back_ends.h"
#include "bench/checked_cut.h"
#include "bench/models.h"
#include "common/proxy/collision_proxy.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

std::unique_ptr<Cuttable> prepared(benchmark::State& state, const Backend& backend, const Model& model,
                                   std::span<const Plane> planes)
{
    PrepareResult result = backend.prepare(model.mesh);
    if (!result.object) {
        state.SkipWithError(result.reason.c_str());
        return nullptr;
    }
    for (const Plane& plane : planes)
        if (const std::string error = check_cut(*result.object, plane); !error.empty()) {
            state.SkipWithError(error.c_str());
            return nullptr;
        }
    return std::move(result.object);
}

void cut_model(benchmark::State& state, const Backend& backend, const Model& model)
{
    const auto planes = planes_of_model(model);
    const auto object = prepared(state, backend, model, planes);
    if (!object) return;
    std::uint64_t cuts = 0, crossing = 0;
    double seconds = 0.0;
    std::vector<std::unique_ptr<Cuttable>> fresh(planes.size());
    std::vector<CutResult> results(planes.size());
    for (auto _ : state) {
        for (auto& copy : fresh) copy = object->clone();
        CpuStopwatch watch;
        for (std::size_t i = 0; i < planes.size(); ++i) results[i] = cut(std::move(fresh[i]), planes[i]);
        const double iteration = watch.lap();
        benchmark::DoNotOptimize(results.data());
        state.SetIterationTime(iteration);
        seconds += iteration;
        cuts += planes.size();
        for (CutResult& result : results) {
            crossing += result.statistics.crossing_triangles;
            result = {};
        }
    }
    const auto triangles = double(model.mesh->triangles.size());
    state.counters["cut_ms"] = seconds * 1e3 / double(cuts);
    state.counters["cuts_each"] = double(planes.size());
    state.counters["triangles"] = triangles;
    state.counters["vertices"] = double(model.mesh->vertices.size());
    state.counters["crossing"] = double(crossing) / double(cuts);
    state.counters["ns_per_triangle"] = seconds * 1e9 / double(cuts) / triangles;
}

/// A way to make a proxy, by the name that its benchmark has.
struct TimedProxy
{
    std::string name;
    bool differs_in_halfedge;  ///< hulls are read off the tree; the other proxies look at every vertex in both
    CollisionProxy (*make)(const Cuttable&);
};

template <ProxyKind kind>
CollisionProxy make_proxy(const Cuttable& object)
{
    return collision_proxy(object, kind);
}

const std::array<TimedProxy, 5>& timed_proxies()
{
    static const std::array<TimedProxy, 5> all{{{"box", false, make_proxy<ProxyKind::box>},
                                                {"sphere", false, make_proxy<ProxyKind::sphere>},
                                                {"bounded_hull", true, make_proxy<ProxyKind::bounded_hull>},
                                                {"full_hull", true, make_proxy<ProxyKind::full_hull>},
                                                {"every_vertex", false, baseline::every_vertex}}};
    return all;
}

void build_proxies(benchmark::State& state, const Backend& backend, const TimedProxy& timed, const Model& model)
{
    const auto planes = planes_of_model(model);
    const auto object = prepared(state, backend, model, planes);
    if (!object) return;
    std::vector<CutResult> cuts;
    for (const Plane& plane : planes) cuts.push_back(cut(object->clone(), plane));
    double volume = 0.0, full_volume = 0.0;

    for (const CutResult& result : cuts)
        for (const auto* side : {&result.positive, &result.negative}) {
            const CollisionProxy proxy = timed.make(*side->front());
            const std::string error = check_proxy(proxy, side->front()->to_indexed_mesh().vertices);
            if (!error.empty()) return state.SkipWithError(error.c_str());
            volume += proxy_volume(proxy);
            full_volume += proxy_volume(collision_proxy(*side->front(), ProxyKind::full_hull));
        }

    double seconds = 0.0;
    std::size_t points = 0;
    for (auto _ : state) {
        points = 0;
        CpuStopwatch watch;
        for (const CutResult& result : cuts)
            for (const auto* side : {&result.positive, &result.negative}) {
                const CollisionProxy proxy = timed.make(*side->front());
                benchmark::DoNotOptimize(proxy.points.data());
                points += proxy.points.size();
            }
        const double iteration = watch.lap();
        state.SetIterationTime(iteration);
        seconds += iteration;
    }
    state.counters["proxy_ms"] = seconds * 1e3 / double(state.iterations()) / double(planes.size());
    state.counters["cuts_each"] = double(planes.size());
    state.counters["points"] = double(points) / (2.0 * double(planes.size()));
    state.counters["volume_ratio"] = volume / full_volume;
    state.counters["triangles"] = double(model.mesh->triangles.size());
}

void prepare_model(benchmark::State& state, const Backend& backend, const Model& model)
{
    if (!prepared(state, backend, model, planes_of_model(model))) return;
    double seconds = 0.0;
    for (auto _ : state) {
        ProvenMesh copy = model.mesh;
        CpuStopwatch watch;
        const PrepareResult result = backend.prepare(std::move(copy));
        const double iteration = watch.lap();
        benchmark::DoNotOptimize(result.object.get());
        state.SetIterationTime(iteration);
        seconds += iteration;
    }
    const auto triangles = double(model.mesh->triangles.size());
    state.counters["triangles"] = triangles;
    state.counters["ns_per_triangle"] = seconds * 1e9 / double(state.iterations()) / triangles;
}

}  // namespace

void register_model_benchmarks()
{
    // The report's methods also run its loop over all vertices for the new pivots; `remap` is nobody's and does not.
    using baseline::VertexLookup;
    static std::vector<std::shared_ptr<Backend>> timed;
    for (const VertexLookup lookup : {VertexLookup::scan, VertexLookup::two_bucket_hash, VertexLookup::hash})
        timed.push_back(baseline::make_back_end(lookup, true));
    for (const TimedBackend& back_end : back_ends()) {
        const std::string name = back_end.backend->name();
        if (std::none_of(timed.begin(), timed.end(), [&](const auto& other) { return other->name() == name; }))
            timed.push_back(back_end.backend);
    }
    for (const Model& model : models()) {
        for (const auto& backend : timed) {
            benchmark::RegisterBenchmark(("Cut/" + backend->name() + "/" + model.name).c_str(),
                                         [&](benchmark::State& s) { cut_model(s, *backend, model); })
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
        for (const TimedProxy& proxy : timed_proxies())
            for (const auto& backend : timed) {
                const bool is_halfedge = backend->name() == "halfedge";
                if (!is_halfedge && backend->name() != "baseline/remap") continue;  // all lookups build alike
                if (is_halfedge && !proxy.differs_in_halfedge) continue;
                const std::string variant = (is_halfedge ? "halfedge/" : "") + proxy.name;
                benchmark::RegisterBenchmark(("Proxy/" + variant + "/" + model.name).c_str(),
                                             [&](benchmark::State& s) { build_proxies(s, *backend, proxy, model); })
                    ->UseManualTime()
                    ->Unit(benchmark::kMillisecond);
            }
        // All lookups prepare alike.
        for (const auto& backend : timed) {
            if (backend->name() == "baseline/scan" || backend->name() == "baseline/two_bucket_hash" ||
                backend->name() == "baseline/hash")
                continue;
            benchmark::RegisterBenchmark(("Prepare/" + backend->name() + "/" + model.name).c_str(),
                                         [&](benchmark::State& s) { prepare_model(s, *backend, model); })
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace kerf::bench
