// What medians hide:
//   Chain/<kept|compacted>/<back end>/asteroid/<triangles>  1000 cuts in a chain, always the largest fragment through
//                                                           its centre of mass: cost and draw ranges on the way.
//                                                           `compacted`: fragments that ask for it are compacted, off
//                                                           the timed path
//   Many/<back end>/asteroid/<triangles>                    the whole chain of a game for many planes anywhere through
//                                                           the mesh's inner half: quantiles and the worst

#include <benchmark/benchmark.h>
#include <kerf/proxy.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/back_ends.h"
#include "bench/checked_cut.h"
#include "bench/machine_memory.h"
#include "bench/objects.h"
#include "bench/timed_shapes.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

constexpr std::uint64_t kLongPlaneSeed = 31;

struct HeapPiece
{
    Object object;
    MassProperties mass;
    std::size_t ranges = 0;
};

struct SmallerVolume
{
    bool operator()(const HeapPiece& a, const HeapPiece& b) const { return a.mass.volume < b.mass.volume; }
};

constexpr std::uint32_t kManyCuts = 200;

/// A chain of cuts is looked at after so many.
constexpr std::array kMarks{1, 3, 10, 20, 30, 40, 60, 100, 300, 1000};

void long_chain(benchmark::State& state, const TimedBackEnd& back_end, std::uint64_t size, bool compacts)
{
    const Mesh& mesh = timed_shape("asteroid", size);
    const auto planes = planes_through_the_middle(mesh.bounds(), kMarks.back(), kLongPlaneSeed);
    const Result<Object> prepared = back_end.prepare(mesh);
    if (!prepared) return state.SkipWithError(prepared.reason());
    const MassProperties whole = prepared->mass_properties();

    DrawView view;
    for (auto _ : state) {
        // A heap by volume: the largest piece is in front.
        std::vector<HeapPiece> pieces;
        pieces.push_back({clone_of(*prepared), whole, 1});
        have_memory_for(mesh.triangle_count());
        double total = 0.0, since_mark = 0.0, worst = 0.0, compacting = 0.0, rest = 0.0;
        std::size_t ranges = 0, most_ranges = 0, compactions = 0, mark = 0;
        int at_mark = 0;
        for (int i = 0; i < kMarks.back(); ++i) {
            std::pop_heap(pieces.begin(), pieces.end(), SmallerVolume{});
            HeapPiece largest = std::move(pieces.back());
            pieces.pop_back();
            ranges -= i == 0 ? 0 : largest.ranges;
            const Plane plane = *Plane::at(Point(largest.mass.centre), planes[std::size_t(i)].normal());
            core::CpuStopwatch watch;
            Cut result = cut(std::move(largest.object), plane);
            const double seconds = watch.lap();
            if (result.status != Status::done) return state.SkipWithError("a plane of the chain cut nothing");
            total += seconds;
            since_mark += seconds;
            worst = std::max(worst, seconds);
            for_each_piece(result, [&](Object& piece) {
                if (compacts && piece.is_scattered()) {
                    core::CpuStopwatch compact_watch;
                    benchmark::DoNotOptimize(piece.compact());
                    compacting += compact_watch.lap();
                    ++compactions;
                }
                // What a game asks of each piece beside the cut itself.
                core::CpuStopwatch rest_watch;
                benchmark::DoNotOptimize(piece.draw(view));
                const std::size_t own = view.ranges.size();
                const MassProperties mass = piece.mass_properties();
                benchmark::DoNotOptimize(bounded_hull(piece)->points().data());
                rest += rest_watch.lap();
                ranges += own;
                most_ranges = std::max(most_ranges, own);
                pieces.push_back({std::move(piece), mass, own});
                std::push_heap(pieces.begin(), pieces.end(), SmallerVolume{});
            });
            if (i + 1 == kMarks[mark]) {
                std::string at = "_";
                at += std::to_string(i + 1);
                state.counters["mean_ms" + at] = since_mark * 1e3 / (i + 1 - at_mark);
                state.counters["worst_ms" + at] = worst * 1e3;
                state.counters["cutting_ms" + at] = total * 1e3;
                state.counters["whole_ms" + at] = (total + rest) * 1e3;
                state.counters["ranges" + at] = double(ranges);
                state.counters["most_ranges" + at] = double(most_ranges);
                state.counters["compactions" + at] = double(compactions);
                state.counters["compact_ms" + at] = compacting * 1e3;
                since_mark = worst = 0.0;
                at_mark = i + 1;
                ++mark;
            }
        }
        state.SetIterationTime(total);
        double volume = 0.0;
        for (const HeapPiece& piece : pieces) volume += piece.mass.volume;
        constexpr double kShare = 1e-6;  // what rounding cut points to float may change
        if (!(std::abs(volume - whole.volume) <= kShare * std::abs(whole.volume)))
            return state.SkipWithError("the volumes of the pieces do not add up");
    }
    state.counters["triangles"] = double(mesh.triangle_count());
}

/// Planes with random directions through random places of the box's inner half.
std::vector<Plane> planes_anywhere(const Box& bounds, std::uint32_t count)
{
    std::vector<Plane> planes;
    // Two directions make a place: their sum lies in a ball, thicker towards its middle.
    const auto normals = planes_through_the_middle(bounds, 3 * count, kLongPlaneSeed);
    const glm::dvec3 half = 0.5 * (to_glm(bounds.hi) - to_glm(bounds.lo));
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 place =
            centre_of(bounds) +
            0.5 * half * 0.5 * (to_glm(normals[3 * i + 1].normal()) + to_glm(normals[3 * i + 2].normal()));
        planes.push_back(*Plane::at(Point(place), normals[3 * i].normal()));
    }
    return planes;
}

double quantile(const std::vector<double>& sorted, double share)
{
    return sorted[std::min(sorted.size() - 1, std::size_t(share * double(sorted.size())))];
}

void many_cuts(benchmark::State& state, const TimedBackEnd& back_end, std::uint64_t size, std::uint32_t count)
{
    constexpr std::size_t kRuns = 5;  // the median of five is the cut's own time, not a neighbour's noise
    constexpr double kFrame = 1.0 / 60.0;
    const Mesh& mesh = timed_shape("asteroid", size);
    const Result<Object> prepared = back_end.prepare(mesh);
    if (!prepared) return state.SkipWithError(prepared.reason());
    const double whole = prepared->mass_properties().volume;
    std::vector<double> seconds;
    DrawView view;
    for (auto _ : state) {
        seconds.clear();
        double sum = 0.0;
        for (const Plane& plane : planes_anywhere(mesh.bounds(), count)) {
            std::array<double, kRuns> runs{};
            for (double& run : runs) {
                Object fresh = clone_of(*prepared);
                double volume = 0.0;
                core::CpuStopwatch watch;
                Cut result = cut(std::move(fresh), plane);
                for_each_piece(result, [&](const Object& piece) {
                    volume += piece.mass_properties().volume;
                    benchmark::DoNotOptimize(bounded_hull(piece)->points().data());
                    benchmark::DoNotOptimize(piece.draw(view));
                    benchmark::DoNotOptimize(view.ranges.data());
                });
                run = watch.lap();
                constexpr double kShare = 1e-6;  // what rounding cut points to float may change
                if (result.status != Status::done || !(std::abs(volume - whole) <= kShare * std::abs(whole)))
                    return state.SkipWithError("a cut gave no two sides of the right volume");
            }
            std::sort(runs.begin(), runs.end());
            seconds.push_back(runs[kRuns / 2]);
            sum += seconds.back();
        }
        state.SetIterationTime(sum);
    }
    std::sort(seconds.begin(), seconds.end());
    state.counters["triangles"] = double(mesh.triangle_count());
    state.counters["cuts"] = double(seconds.size());
    state.counters["p50_ms"] = quantile(seconds, 0.5) * 1e3;
    state.counters["p90_ms"] = quantile(seconds, 0.9) * 1e3;
    state.counters["p99_ms"] = quantile(seconds, 0.99) * 1e3;
    state.counters["worst_ms"] = seconds.back() * 1e3;
    state.counters["over_frame"] =
        double(std::count_if(seconds.begin(), seconds.end(), [](double s) { return s > kFrame; }));
}

}  // namespace

void register_long_benchmarks()
{
    for (const std::uint64_t size : {10'000ull, 100'000ull, 1'000'000ull})
        for (const TimedBackEnd& back_end : back_ends()) {
            const std::string name = back_end.name, tail = name + "/asteroid/" + std::to_string(size);
            const auto add = [&](const std::string& full_name, auto function) {
                benchmark::RegisterBenchmark(full_name.c_str(), function)
                    ->UseManualTime()
                    ->Iterations(1)
                    ->Unit(benchmark::kMillisecond);
            };
            if (name == "baseline/remap" || name == "halfedge")
                add("Chain/kept/" + tail,
                    [&back_end, size](benchmark::State& s) { long_chain(s, back_end, size, false); });
            if (name == "halfedge")
                add("Chain/compacted/" + tail,
                    [&back_end, size](benchmark::State& s) { long_chain(s, back_end, size, true); });
            if (name == "baseline/hash" || name == "baseline/remap" || name == "halfedge") {
                // A dictionary's cuts of a million triangles take longer than all others together.
                if (name == "baseline/hash" && size > 100'000) continue;
                add("Many/" + tail,
                    [&back_end, size](benchmark::State& s) { many_cuts(s, back_end, size, kManyCuts); });
            }
        }
}

}  // namespace kerf::bench
