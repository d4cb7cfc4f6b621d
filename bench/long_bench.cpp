// What medians hide:
//   Chain/<kept|compacted>/<back end>/asteroid/<triangles>  1000 cuts in a chain, always the largest fragment through
//                                                           its centre of mass: cost and draw ranges on the way.
//                                                           `compacted`: fragments that ask for it are compacted, off
//                                                           the timed path. Each cut is the median of five chains;
//                                                           `worst_to_predicted` is the worst of all thousand
//   Many/<back end>/asteroid/<triangles>                    the whole chain of a game for many planes anywhere through
//                                                           the mesh's inner half: quantiles and the worst

#include <benchmark/benchmark.h>
#include <kerf/proxy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/back_ends.h"
#include "bench/checked_cut.h"
#include "bench/machine_memory.h"
#include "bench/objects.h"
#include "bench/predicted_cost.h"
#include "bench/timed_shapes.h"
#include "common/support/cpu_stopwatch.h"
#include "common/support/median.h"

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
constexpr int kChainsEach = 5;

/// One cut of a chain, and what stands there after it.
struct Step
{
    double crossing = 0.0, cut_seconds = 0.0;
    double rest_seconds = 0.0;  ///< draw views, masses and hulls of what came out
    double compact_seconds = 0.0;
    std::size_t ranges = 0;       ///< of all pieces together
    std::size_t most_ranges = 0;  ///< of a piece that came out
    std::size_t compactions = 0;
};

struct LongChain
{
    std::vector<Step> steps;
    std::string error;
};

LongChain cut_long_chain(Object object, std::span<const Plane> planes, bool compacts)
{
    LongChain chain;
    const MassProperties whole = object.mass_properties();
    // A heap by volume: the largest piece is in front.
    std::vector<HeapPiece> pieces;
    pieces.push_back({std::move(object), whole, 1});
    DrawView view;
    std::size_t ranges = 1;
    for (const Plane& direction : planes) {
        std::pop_heap(pieces.begin(), pieces.end(), SmallerVolume{});
        HeapPiece largest = std::move(pieces.back());
        pieces.pop_back();
        ranges -= largest.ranges;
        const Plane plane = *Plane::at(Point(largest.mass.centre), direction.normal());
        Step step;
        core::CpuStopwatch watch;
        Cut result = cut(std::move(largest.object), plane);
        step.cut_seconds = watch.lap();
        if (result.status != Status::done) {
            chain.error = "a plane of the chain cut nothing";
            return chain;
        }
        step.crossing = double(result.statistics().crossing_triangles);
        for_each_piece(result, [&](Object& piece) {
            if (compacts && piece.is_scattered()) {
                core::CpuStopwatch compact_watch;
                benchmark::DoNotOptimize(piece.compact());
                step.compact_seconds += compact_watch.lap();
                ++step.compactions;
            }
            // What a game asks of each piece beside the cut itself.
            core::CpuStopwatch rest_watch;
            benchmark::DoNotOptimize(piece.draw(view));
            const std::size_t own = view.ranges.size();
            const MassProperties mass = piece.mass_properties();
            benchmark::DoNotOptimize(bounded_hull(piece)->points().data());
            step.rest_seconds += rest_watch.lap();
            ranges += own;
            step.most_ranges = std::max(step.most_ranges, own);
            pieces.push_back({std::move(piece), mass, own});
            std::push_heap(pieces.begin(), pieces.end(), SmallerVolume{});
        });
        step.ranges = ranges;
        chain.steps.push_back(step);
    }
    double volume = 0.0;
    for (const HeapPiece& piece : pieces) volume += piece.mass.volume;
    constexpr double kShare = 1e-6;  // what rounding cut points to float may change
    if (!(std::abs(volume - whole.volume) <= kShare * std::abs(whole.volume)))
        chain.error = "the volumes of the pieces do not add up";
    return chain;
}

/// The times of each step are the medians of all chains: a neighbour's noise is not the cut's. All else is equal in them.
std::vector<Step> medians_of(std::span<const LongChain> chains)
{
    std::vector<Step> steps = chains.front().steps;
    for (std::size_t i = 0; i < steps.size(); ++i)
        for (double Step::*const seconds : {&Step::cut_seconds, &Step::rest_seconds, &Step::compact_seconds}) {
            std::vector<double> all;
            for (const LongChain& chain : chains) all.push_back(chain.steps[i].*seconds);
            steps[i].*seconds = core::median(std::move(all));
        }
    return steps;
}

/// What there was to see at each mark: since the one before, or so far.
void count_marks(benchmark::State& state, std::span<const Step> steps)
{
    double total = 0.0, rest = 0.0, compacting = 0.0;
    std::size_t most_ranges = 0, compactions = 0, next = 0;
    for (const int mark : kMarks) {
        double since_mark = 0.0, worst = 0.0;
        const std::size_t before = next;
        for (; next < std::size_t(mark); ++next) {
            const Step& step = steps[next];
            since_mark += step.cut_seconds;
            worst = std::max(worst, step.cut_seconds);
            rest += step.rest_seconds;
            compacting += step.compact_seconds;
            most_ranges = std::max(most_ranges, step.most_ranges);
            compactions += step.compactions;
        }
        total += since_mark;
        std::string at = "_";
        at += std::to_string(mark);
        state.counters["mean_ms" + at] = since_mark * 1e3 / double(next - before);
        state.counters["worst_ms" + at] = worst * 1e3;
        state.counters["cutting_ms" + at] = total * 1e3;
        state.counters["whole_ms" + at] = (total + rest) * 1e3;
        state.counters["ranges" + at] = double(steps[next - 1].ranges);
        state.counters["most_ranges" + at] = double(most_ranges);
        state.counters["compactions" + at] = double(compactions);
        state.counters["compact_ms" + at] = compacting * 1e3;
    }
}

void long_chain(benchmark::State& state, const TimedBackEnd& back_end, std::uint64_t size, bool compacts)
{
    const Mesh& mesh = timed_shape("asteroid", size);
    const auto planes = planes_through_the_middle(mesh.bounds(), kMarks.back(), kLongPlaneSeed);
    const Result<Object> prepared = back_end.prepare(mesh);
    if (!prepared) return state.SkipWithError(prepared.reason());
    std::vector<Step> steps;
    for (auto _ : state) {
        std::vector<LongChain> chains;
        for (int i = 0; i < kChainsEach; ++i) {
            have_memory_for(mesh.triangle_count());
            chains.push_back(cut_long_chain(clone_of(*prepared), planes, compacts));
            if (!chains.back().error.empty()) return state.SkipWithError(chains.back().error.c_str());
        }
        steps = medians_of(chains);
        double total = 0.0;
        for (const Step& step : steps) total += step.cut_seconds;
        state.SetIterationTime(total);
    }
    count_marks(state, steps);
    std::vector<CutCost> costs;
    for (const Step& step : steps) costs.push_back({step.crossing, step.cut_seconds});
    const WorstCut worst = worst_to_predicted(costs);
    state.counters["worst_to_predicted"] = worst.to_predicted;
    state.counters["worst_to_predicted_at"] = double(worst.number + 1);
    state.counters["chains"] = kChainsEach;
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
