// The report's fifteen models, ten cuts each (its Table 2):
//   Cut/<back end>/<model>        one cut, fan and new pivots included, as the report times it
//   Proxy/<kind>/<model>          the collision proxies of both fragments of a cut, linear back end
//   Proxy/halfedge/<kind>/<model> the hulls of the same fragments, half-edge back end
//   Prepare/<back end>/<model>    making a mesh ready for cutting
// Loading, cloning and destroying stay untimed.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/back_ends.h"
#include "bench/checked_cut.h"
#include "bench/models.h"
#include "bench/objects.h"
#include "bench/proxies.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

/// An empty object if one of the cuts must not be timed; `state` has the error then.
Object prepared(benchmark::State& state, const TimedBackEnd& back_end, const Model& model,
                std::span<const Plane> planes)
{
    Result<Object> result = back_end.prepare(model.mesh);
    if (!result) {
        state.SkipWithError(result.reason());
        return {};
    }
    for (const Plane& plane : planes)
        if (const std::string error = check_cut(*result, plane); !error.empty()) {
            state.SkipWithError(error.c_str());
            return {};
        }
    return *std::move(result);
}

/// The views of all pieces of some cuts.
std::vector<DrawView> views_of(std::span<Cut> cuts)
{
    std::vector<DrawView> views;
    for (Cut& cut : cuts)
        for_each_piece(cut, [&](const Object& piece) {
            if (piece.draw(views.emplace_back()) != Status::done) throw std::runtime_error("a piece can't be drawn");
        });
    return views;
}

/// The report's loop that rewrites every vertex of a piece around its new pivot. The result is thrown away, because
/// coordinates never change: a piece's pivot belongs in its transform.
void rewrite_around_pivot(std::span<const DrawVertex> vertices)
{
    double x = 0.0, y = 0.0, z = 0.0;
    for (const DrawVertex& v : vertices) {
        x += double(v.position.x);
        y += double(v.position.y);
        z += double(v.position.z);
    }
    const double count = std::max(1.0, double(vertices.size()));
    const Vec3f pivot(Vec3d(x / count, y / count, z / count));
    // Room that nobody clears first.
    struct Written
    {
        float numbers[8];
    };
    static_assert(sizeof(Written) == sizeof(DrawVertex));
    const auto scratch = std::make_unique_for_overwrite<Written[]>(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto& [p, n, uv] = vertices[i];
        scratch[i] = {p.x - pivot.x, p.y - pivot.y, p.z - pivot.z, n.x, n.y, n.z, uv.x, uv.y};
    }
    benchmark::DoNotOptimize(scratch.get());
    benchmark::ClobberMemory();
}

/// `rewrites_pivots`: the report's new pivots belong to the cut.
void cut_model(benchmark::State& state, const TimedBackEnd& back_end, const Model& model, bool rewrites_pivots)
{
    const auto planes = planes_of_model(model);
    const Object object = prepared(state, back_end, model, planes);
    if (object.is_empty()) return;
    std::uint64_t cuts = 0, crossing = 0;
    double seconds = 0.0;
    std::vector<Object> fresh(planes.size());
    std::vector<Cut> results(planes.size());
    for (auto _ : state) {
        for (Object& copy : fresh) copy = clone_of(object);
        core::CpuStopwatch watch;
        for (std::size_t i = 0; i < planes.size(); ++i) results[i] = cut(std::move(fresh[i]), planes[i]);
        double iteration = watch.lap();
        benchmark::DoNotOptimize(results.data());
        if (rewrites_pivots) {
            // After all cuts, so that neither the views nor a clock in each cut is timed with them.
            const std::vector<DrawView> views = views_of(results);
            watch.lap();
            for (const DrawView& view : views) rewrite_around_pivot(view.vertices);
            iteration += watch.lap();
        }
        state.SetIterationTime(iteration);
        seconds += iteration;
        cuts += planes.size();
        for (Cut& result : results) {
            crossing += result.statistics().crossing_triangles;
            result = {};
        }
    }
    const auto triangles = double(model.mesh.triangle_count());
    state.counters["cut_ms"] = seconds * 1e3 / double(cuts);
    state.counters["cuts_each"] = double(planes.size());
    state.counters["triangles"] = triangles;
    state.counters["vertices"] = double(model.mesh.vertex_count());
    state.counters["crossing"] = double(crossing) / double(cuts);
    state.counters["ns_per_triangle"] = seconds * 1e9 / double(cuts) / triangles;
}

/// Hulls are read off the tree; the other proxies look at every vertex in both.
bool differs_in_halfedge(ProxyKind kind)
{
    return kind == ProxyKind::bounded_hull || kind == ProxyKind::full_hull;
}

void build_proxies(benchmark::State& state, const TimedBackEnd& back_end, ProxyKind kind, const Model& model)
{
    const auto planes = planes_of_model(model);
    const Object object = prepared(state, back_end, model, planes);
    if (object.is_empty()) return;
    std::vector<Cut> cuts;
    for (const Plane& plane : planes) cuts.push_back(cut(clone_of(object), plane));
    std::vector<const Object*> pieces;
    for (Cut& cut : cuts)
        for (const Side side : {Side::positive, Side::negative}) pieces.push_back(cut.one(side));
    double volume = 0.0, full_volume = 0.0;

    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Proxy proxy = make_proxy(kind, *pieces[i]);
        const Hull full = value_of(full_hull(*pieces[i]));
        const std::string error = check_proxy(proxy, *pieces[i], full);
        if (!error.empty()) return state.SkipWithError(error.c_str());
        volume += proxy_volume(proxy, full);
        full_volume += volume_of(full);
    }

    double seconds = 0.0;
    std::size_t points = 0;
    for (auto _ : state) {
        points = 0;
        core::CpuStopwatch watch;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Proxy proxy = make_proxy(kind, *pieces[i]);
            benchmark::DoNotOptimize(proxy.corners().data());
            points += proxy.corners().size();
        }
        const double iteration = watch.lap();
        state.SetIterationTime(iteration);
        seconds += iteration;
    }
    state.counters["proxy_ms"] = seconds * 1e3 / double(state.iterations()) / double(planes.size());
    state.counters["cuts_each"] = double(planes.size());
    state.counters["points"] = double(points) / (2.0 * double(planes.size()));
    state.counters["volume_ratio"] = volume / full_volume;
    state.counters["triangles"] = double(model.mesh.triangle_count());
}

void prepare_model(benchmark::State& state, const TimedBackEnd& back_end, const Model& model)
{
    if (!prepared(state, back_end, model, planes_of_model(model))) return;
    double seconds = 0.0;
    for (auto _ : state) {
        Mesh copy = value_of(model.mesh.clone());
        core::CpuStopwatch watch;
        const Result<Object> result = back_end.prepare(std::move(copy));
        const double iteration = watch.lap();
        benchmark::DoNotOptimize(&result);
        state.SetIterationTime(iteration);
        seconds += iteration;
    }
    const auto triangles = double(model.mesh.triangle_count());
    state.counters["triangles"] = triangles;
    state.counters["ns_per_triangle"] = seconds * 1e9 / double(state.iterations()) / triangles;
}

/// A back end, and whether the report's new pivots belong to its cuts.
struct TimedMethod
{
    TimedBackEnd back_end;
    bool rewrites_pivots = false;
};

/// Those of the report first, in its order. They also run its loop over all vertices for the new pivots; `remap` is
/// nobody's and does not.
std::vector<TimedMethod> timed_methods()
{
    std::vector<TimedMethod> timed;
    const auto& all = back_ends();
    for (const std::string name : {"baseline/scan", "baseline/two_bucket_hash", "baseline/hash"}) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
        timed.push_back({*found, true});
    }
    for (const TimedBackEnd& back_end : all)
        if (std::none_of(timed.begin(), timed.end(),
                         [&](const TimedMethod& other) { return other.back_end.name == back_end.name; }))
            timed.push_back({back_end, false});
    return timed;
}

}  // namespace

void register_model_benchmarks()
{
    static const std::vector<TimedMethod> timed = timed_methods();
    const auto add = [](const std::string& name, auto function) {
        benchmark::RegisterBenchmark(name.c_str(), function)->UseManualTime()->Unit(benchmark::kMillisecond);
    };
    for (const Model& model : models()) {
        for (const TimedMethod& method : timed)
            add("Cut/" + method.back_end.name + "/" + model.name, [&method, &model](benchmark::State& s) {
                cut_model(s, method.back_end, model, method.rewrites_pivots);
            });
        for (const ProxyKind kind : kProxyKinds)
            for (const TimedMethod& method : timed) {
                const TimedBackEnd& back_end = method.back_end;
                const bool is_halfedge = back_end.name == "halfedge";
                if (!is_halfedge && back_end.name != "baseline/remap") continue;  // all lookups build alike
                if (is_halfedge && !differs_in_halfedge(kind)) continue;
                const std::string variant = (is_halfedge ? "halfedge/" : "") + name_of(kind);
                add("Proxy/" + variant + "/" + model.name,
                    [&back_end, kind, &model](benchmark::State& s) { build_proxies(s, back_end, kind, model); });
            }
        // All lookups prepare alike.
        for (const TimedMethod& method : timed) {
            const TimedBackEnd& back_end = method.back_end;
            if (method.rewrites_pivots || back_end.differs_in_caps_only()) continue;
            add("Prepare/" + back_end.name + "/" + model.name,
                [&back_end, &model](benchmark::State& s) { prepare_model(s, back_end, model); });
        }
    }
}

}  // namespace kerf::bench
