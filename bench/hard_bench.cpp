// Sections that are hard on a cutter (shapes/hard_sections.h), at a quarter of the size and at full size: a step that
// is quadratic somewhere shows as a factor of sixteen.
//   Hard/<back end>/<section>/<size>   the cut (time), and counters in ms: `assemble` (repair()), `prepare`, `pieces` (the same
//                                      cut into connected pieces), `again` (both fragments of the cut, cut into pieces
//                                      by a plane at right angles)

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>

#include "bench/back_ends.h"
#include "common/mesh/plane_frame.h"
#include "common/repair/repair.h"
#include "common/shapes/hard_sections.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

constexpr int kRuns = 3;  // the least of three is the work itself

/// The least milliseconds that `timed` takes on what `make` gives it.
template <class Make, class Timed>
double least_ms(Make make, Timed timed)
{
    double least = 0.0;
    for (int run = 0; run < kRuns; ++run) {
        auto input = make();
        CpuStopwatch watch;
        const auto result = timed(std::move(input));
        const double seconds = watch.lap();
        benchmark::DoNotOptimize(&result);
        least = run == 0 ? seconds : std::min(least, seconds);
    }
    return least * 1e3;
}

/// Through the middle of what was cut, at right angles to the first plane.
Plane second_plane(const Cuttable& object, const Plane& first)
{
    const PlaneFrame frame = PlaneFrame::of(first.normal);
    return *Plane::through(object.bounds().centre(), frame.u + 0.25 * frame.v);
}

using Pieces = std::vector<std::unique_ptr<Cuttable>>;

void hard_section(benchmark::State& state, const Backend& backend, const std::string& name, std::uint32_t size)
{
    for (auto _ : state) {
        const shapes::HardSection section = *shapes::hard_section(name, size);
        const Plane& plane = section.plane;
        const ProvenMesh mesh = repair(section.soup).mesh;
        const PrepareResult prepared = backend.prepare(mesh);
        if (!prepared.object) return state.SkipWithError(prepared.reason.c_str());
        state.counters["assemble"] =
            least_ms([&] { return section.soup; }, [](TriangleSoup soup) { return repair(std::move(soup)); });
        state.counters["prepare"] = least_ms([&] { return ProvenMesh(mesh); },
                                             [&](ProvenMesh copy) { return backend.prepare(std::move(copy)); });

        const auto clone = [&] { return prepared.object->clone(); };
        CutOptions pieces;
        pieces.split_components = true;
        const CutResult result = cut(clone(), plane);
        if (result.status != Status::done) return state.SkipWithError("the plane cuts nothing");
        state.SetIterationTime(
            1e-3 * least_ms(clone, [&](std::unique_ptr<Cuttable> object) { return cut(std::move(object), plane); }));
        std::size_t piece_count = 0;
        state.counters["pieces"] = least_ms(clone, [&](std::unique_ptr<Cuttable> object) {
            CutResult fell_apart = cut(std::move(object), plane, pieces);
            piece_count = fell_apart.negative.size() + fell_apart.positive.size();
            return fell_apart;
        });
        state.counters["again"] = least_ms([&] { return cut(clone(), plane); },
                                           [&](CutResult sides) {
                                               std::array<CutResult, 2> again;
                                               for (std::size_t i = 0; i < 2; ++i) {
                                                   auto& object = (i == 0 ? sides.negative : sides.positive).front();
                                                   const Plane second = second_plane(*object, plane);
                                                   again[i] = cut(std::move(object), second, pieces);
                                               }
                                               return again;
                                           });
        state.counters["triangles"] = double(result.statistics.triangles);
        state.counters["crossing"] = double(result.statistics.crossing_triangles);
        state.counters["loops"] = double(result.statistics.section_loops);
        state.counters["fragments"] = double(piece_count);
    }
}

}  // namespace

void register_hard_benchmarks()
{
    for (const std::string& name : shapes::hard_section_names())
        for (const TimedBackend& back_end : back_ends()) {
            const std::string method = back_end.backend->name();
            if (method != "baseline/remap" && method != "halfedge") continue;
            constexpr std::array kOneLoop{"comb", "leaning_comb", "spiral", "tip", "toothed_tip", "touches"};
            const bool is_one_loop = std::find(kOneLoop.begin(), kOneLoop.end(), name) != kOneLoop.end();
            const std::uint32_t full = name.starts_with("flat") ? 1'000'000 : is_one_loop ? 100'000 : 10'000;
            for (const std::uint32_t size : {full / 4, full}) {
                const std::string full_name = "Hard/" + method + "/" + name + "/" + std::to_string(size);
                benchmark::RegisterBenchmark(
                    full_name.c_str(),
                    [&back_end, name, size](benchmark::State& s) { hard_section(s, *back_end.backend, name, size); })
                    ->UseManualTime()
                    ->Iterations(1)
                    ->Unit(benchmark::kMillisecond);
            }
        }
}

}  // namespace kerf::bench
