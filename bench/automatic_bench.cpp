// Whether the back end that is chosen by itself is the right one:
//   Automatic/asteroid/<triangles>, Automatic/model/<model>, Automatic/mesh/<mesh>
// For both back ends that prepare() may choose: preparing once, and the whole chain that a game needs of a cut of a copy. The
// counters `to_better_<cuts>` say how much longer as many cuts take, preparing among it, with the choice that prepare() makes
// for that number than with the better one. `to_best_<cuts>` takes the report's `remap` for a third one: it is never chosen,
// because its caps are fans, which are wrong where a section is not star-shaped.

#include <benchmark/benchmark.h>
#include <kerf/proxy.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "bench/back_ends.h"
#include "bench/models.h"
#include "bench/objects.h"
#include "bench/real_meshes.h"
#include "bench/timed_shapes.h"
#include "common/support/cpu_stopwatch.h"
#include "common/support/median.h"

namespace kerf::bench {

namespace {

constexpr std::array<std::uint32_t, 8> kCutsExpected{1, 2, 5, 10, 20, 50, 100, 1000};
constexpr std::array kBackEnds{"linear", "halfedge", "baseline/remap"};
constexpr std::size_t kChoices = 2;  ///< the first ones may be chosen
constexpr int kRepetitions = 7;      ///< of preparing, and of each cut; medians count

/// Seconds, with one back end.
struct Costs
{
    double prepare = 0.0, cut = 0.0;

    double of(std::uint32_t cuts) const { return prepare + cuts * cut; }
};

Object prepared_by(const Mesh& mesh, const char* back_end)
{
    PrepareOptions options;
    options.back_end_name = back_end;
    return value_of(prepare(mesh, options));
}

double seconds_of_cut(const Object& object, const Plane& plane)
{
    DrawView view;
    Object fresh = clone_of(object);
    core::CpuStopwatch watch;
    Cut result = cut(std::move(fresh), plane);
    for_each_piece(result, [&](const Object& piece) {
        benchmark::DoNotOptimize(piece.mass_properties());
        benchmark::DoNotOptimize(bounded_hull(piece)->points().data());
        benchmark::DoNotOptimize(piece.draw(view));
    });
    return watch.lap();
}

Costs costs_of(const Mesh& mesh, const std::vector<Plane>& planes, const char* back_end)
{
    // The first one touches memory that the others find touched, as in a program that has run for a while.
    const Object object = prepared_by(mesh, back_end);
    std::vector<double> preparing;
    for (int i = 0; i < kRepetitions; ++i) {
        core::CpuStopwatch watch;
        const Object again = prepared_by(mesh, back_end);
        preparing.push_back(watch.lap());
    }
    Costs costs{core::median(std::move(preparing)), 0.0};
    for (const Plane& plane : planes) {
        std::vector<double> cutting;
        for (int i = 0; i < kRepetitions; ++i) cutting.push_back(seconds_of_cut(object, plane));
        costs.cut += core::median(std::move(cutting)) / double(planes.size());
    }
    return costs;
}

void judge_choices(benchmark::State& state, const Mesh& mesh, const std::vector<Plane>& planes)
{
    for (auto _ : state) {
        std::array<Costs, kBackEnds.size()> costs;
        double total = 0.0;
        for (std::size_t i = 0; i < kBackEnds.size(); ++i) {
            costs[i] = costs_of(mesh, planes, kBackEnds[i]);
            total += costs[i].of(1);
        }
        double worst_to_better = 1.0, worst_to_best = 1.0;
        for (const std::uint32_t cuts : kCutsExpected) {
            PrepareOptions options;
            options.cuts_expected = cuts;
            const std::string_view chosen = value_of(prepare(mesh, options)).back_end_name();
            const double own = costs[chosen == kBackEnds[0] ? 0 : 1].of(cuts);
            const auto least = [&](std::size_t count) {
                double least_cost = own;
                for (std::size_t i = 0; i < count; ++i) least_cost = std::min(least_cost, costs[i].of(cuts));
                return least_cost;
            };
            const double to_better = own / least(kChoices), to_best = own / least(kBackEnds.size());
            state.counters["to_better_" + std::to_string(cuts)] = to_better;
            state.counters["to_best_" + std::to_string(cuts)] = to_best;
            worst_to_better = std::max(worst_to_better, to_better);
            worst_to_best = std::max(worst_to_best, to_best);
        }
        for (std::size_t i = 0; i < kBackEnds.size(); ++i) {
            const std::string name = kBackEnds[i];
            state.counters["prepare_ms_" + name] = costs[i].prepare * 1e3;
            state.counters["cut_ms_" + name] = costs[i].cut * 1e3;
        }
        state.counters["worst_to_better"] = worst_to_better;
        state.counters["worst_to_best"] = worst_to_best;
        state.SetIterationTime(total);
    }
    state.counters["triangles"] = double(mesh.triangle_count());
    state.counters["vertices"] = double(mesh.vertex_count());
}

void register_choice(const std::string& name, auto judge)
{
    benchmark::RegisterBenchmark(("Automatic/" + name).c_str(), judge)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_automatic_benchmarks()
{
    if (!std::ranges::any_of(back_ends(), [](const TimedBackEnd& b) { return b.name == "halfedge"; })) return;
    constexpr std::array<std::uint64_t, 8> kSizes{1'000, 3'000, 10'000, 30'000, 100'000, 300'000, 1'000'000, 4'000'000};
    for (const std::uint64_t size : kSizes)
        register_choice("asteroid/" + std::to_string(size), [size](benchmark::State& state) {
            const Mesh& mesh = timed_shape("asteroid", size);
            judge_choices(state, mesh, planes_of_shape(mesh));
        });
    for (const Model& model : models())
        register_choice("model/" + model.name, [&model](benchmark::State& state) {
            judge_choices(state, model.mesh, planes_of_model(model));
        });
    for (const RealMesh& real : real_meshes())
        register_choice("mesh/" + real.name, [real](benchmark::State& state) {
            const Mesh& mesh = mesh_of(real);
            judge_choices(state, mesh, planes_of_shape(mesh));
        });
}

}  // namespace kerf::bench
