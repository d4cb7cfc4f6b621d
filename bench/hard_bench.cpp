// Sections that are hard on a cutter (make_hard_section()), at a quarter of the size and at full size: a step that
// is quadratic somewhere shows as a factor of sixteen.
//   Hard/<back end>/<section>/<size>   the cut (time), and counters in ms: `assemble` (Mesh::make()), `prepare`,
//                                      `pieces` (the same cut into connected pieces), `again` (both fragments of the
//                                      cut, cut into pieces by a plane at right angles)

#include <benchmark/benchmark.h>
#include <kerf/cut.h>
#include <kerf/shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "bench/back_ends.h"
#include "bench/objects.h"
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
        core::CpuStopwatch watch;
        const auto result = timed(std::move(input));
        const double seconds = watch.lap();
        benchmark::DoNotOptimize(&result);
        least = run == 0 ? seconds : std::min(least, seconds);
    }
    return least * 1e3;
}

/// Through the middle of what was cut, at right angles to the first plane.
Plane second_plane(const Object& object, const Plane& first)
{
    // Begins with the axis that is farthest from the normal: the product is never short.
    const glm::dvec3 normal = to_glm(first.normal()), size = glm::abs(normal);
    glm::dvec3 axis{0, 0, 1};
    if (size.x <= size.y && size.x <= size.z)
        axis = {1, 0, 0};
    else if (size.y <= size.z)
        axis = {0, 1, 0};
    const glm::dvec3 u = glm::normalize(glm::cross(axis, normal)), v = glm::cross(normal, u);
    return *Plane::at(Point(centre_of(object.bounds())), Normal(u + 0.25 * v));
}

void hard_section(benchmark::State& state, const TimedBackEnd& back_end, const std::string& name, std::uint32_t size)
{
    for (auto _ : state) {
        const HardSection section = value_of(make_hard_section(name.c_str(), size));
        const Plane plane = section.plane();
        const Mesh mesh = value_of(Mesh::make(section.input()));
        const Result<Object> prepared = back_end.prepare(mesh);
        if (!prepared) return state.SkipWithError(prepared.reason());
        state.counters["assemble"] =
            least_ms([&] { return section.input(); }, [](const MeshInput& input) { return Mesh::make(input); });
        state.counters["prepare"] = least_ms([&] { return value_of(mesh.clone()); },
                                             [&](Mesh copy) { return back_end.prepare(std::move(copy)); });

        const auto clone = [&] { return clone_of(*prepared); };
        CutOptions pieces;
        pieces.components = true;
        const Cut result = cut(clone(), plane);
        if (result.status != Status::done) return state.SkipWithError("the plane cuts nothing");
        state.SetIterationTime(1e-3 * least_ms(clone, [&](Object object) { return cut(std::move(object), plane); }));
        std::size_t piece_count = 0;
        state.counters["pieces"] = least_ms(clone, [&](Object object) {
            Cut fell_apart = cut(std::move(object), plane, pieces);
            piece_count = fell_apart.count(Side::negative) + fell_apart.count(Side::positive);
            return fell_apart;
        });
        state.counters["again"] = least_ms([&] { return cut(clone(), plane); },
                                           [&](Cut sides) {
                                               std::array<Cut, 2> again;
                                               for (std::size_t i = 0; i < 2; ++i) {
                                                   const Side side = i == 0 ? Side::negative : Side::positive;
                                                   Object& object = *sides.one(side);
                                                   const Plane second = second_plane(object, plane);
                                                   again[i] = cut(std::move(object), second, pieces);
                                               }
                                               return again;
                                           });
        state.counters["triangles"] = double(result.statistics().triangles);
        state.counters["crossing"] = double(result.statistics().crossing_triangles);
        state.counters["loops"] = double(result.statistics().section_loops);
        state.counters["fragments"] = double(piece_count);
    }
}

}  // namespace

void register_hard_benchmarks()
{
    for (std::size_t i = 0; const char* const known = hard_section_name(i); ++i)
        for (const TimedBackEnd& back_end : back_ends()) {
            const std::string name = known, method = back_end.name;
            if (method != "baseline/remap" && method != "halfedge") continue;
            constexpr std::array kOneLoop{"comb", "leaning_comb", "spiral", "tip", "toothed_tip", "touches"};
            const bool is_one_loop = std::find(kOneLoop.begin(), kOneLoop.end(), name) != kOneLoop.end();
            const std::uint32_t full = name.starts_with("flat") ? 1'000'000 : is_one_loop ? 100'000 : 10'000;
            for (const std::uint32_t size : {full / 4, full}) {
                const std::string full_name = "Hard/" + method + "/" + name + "/" + std::to_string(size);
                benchmark::RegisterBenchmark(
                    full_name.c_str(),
                    [&back_end, name, size](benchmark::State& s) { hard_section(s, back_end, name, size); })
                    ->UseManualTime()
                    ->Iterations(1)
                    ->Unit(benchmark::kMillisecond);
            }
        }
}

}  // namespace kerf::bench
