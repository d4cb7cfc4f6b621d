//   Recut/<back end>/<shape>/<triangles>    100 cuts in a chain: always the largest fragment, through its centre of
//                                           mass
//   Prepare/<back end>/<shape>/<triangles>  making a mesh ready for cutting, and the memory that it takes from then on
//   PrepareThreads/<threads>/halfedge/...   the same by so many threads: the time that passes

#include <benchmark/benchmark.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

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

constexpr std::uint32_t kCutsInAChain = 100;
constexpr int kChains = 5;
constexpr std::uint64_t kPlaneSeed = 7;

struct Piece
{
    Object object;
    MassProperties mass;
};

/// What one chain of cuts took and left behind.
struct Chain
{
    std::vector<CutCost> cuts;
    double seconds = 0.0, volume = 0.0;
    std::size_t most_ranges = 0;
    std::string error;
};

Chain cut_in_a_chain(Object object, std::span<const Normal> normals)
{
    Chain chain;
    std::vector<Piece> pieces;
    const MassProperties whole = object.mass_properties();
    pieces.push_back({std::move(object), whole});
    DrawView view;
    for (const Normal& normal : normals) {
        const auto largest = std::max_element(
            pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.mass.volume < b.mass.volume; });
        const Plane plane = *Plane::at(Point(largest->mass.centre), normal);
        core::CpuStopwatch watch;
        Cut result = cut(std::move(largest->object), plane);
        const double seconds = watch.lap();
        if (result.status != Status::done) {
            chain.error = "a cut of the chain gave status " + std::string(text(result.status));
            return chain;
        }
        pieces.erase(largest);
        for_each_piece(result, [&](Object& piece) {
            const MassProperties mass = piece.mass_properties();
            if (piece.draw(view) != Status::done) chain.error = "a piece can't be drawn";
            chain.most_ranges = std::max(chain.most_ranges, view.ranges.size());
            pieces.push_back({std::move(piece), mass});
        });
        chain.seconds += seconds;
        chain.cuts.push_back({double(result.statistics().crossing_triangles), seconds});
    }
    for (const Piece& piece : pieces) chain.volume += piece.mass.volume;
    constexpr double kShare = 1e-6;  // what rounding cut points to float may change
    if (!(std::abs(chain.volume - whole.volume) <= kShare * std::abs(whole.volume)))
        chain.error = "the volumes of the pieces do not add up";
    return chain;
}

void recut(benchmark::State& state, const TimedBackEnd& back_end, const std::string& shape, std::uint64_t size)
{
    const Mesh& mesh = timed_shape(shape, size);
    std::vector<Normal> normals;
    for (const Plane& plane : planes_through_the_middle(mesh.bounds(), kCutsInAChain, kPlaneSeed))
        normals.push_back(plane.normal());
    const Result<Object> prepared = back_end.prepare(mesh);
    if (!prepared) return state.SkipWithError(prepared.reason());

    // Each cut is repeated in a chain of its own and judged by its median: a neighbour's noise is not the cut's.
    std::vector<std::vector<double>> seconds(kCutsInAChain);
    Chain chain;
    for (auto _ : state) {
        double total = 0.0;
        for (int repetition = 0; repetition < kChains; ++repetition) {
            chain = cut_in_a_chain(clone_of(*prepared), normals);
            if (!chain.error.empty()) return state.SkipWithError(chain.error.c_str());
            for (std::size_t i = 0; i < kCutsInAChain; ++i) seconds[i].push_back(chain.cuts[i].seconds);
            total += chain.seconds;
        }
        state.SetIterationTime(total / kChains);
    }
    double sum = 0.0, crossing = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < kCutsInAChain; ++i) {
        CutCost& cut = chain.cuts[i];
        cut.seconds = core::median(std::move(seconds[i]));
        sum += cut.seconds;
        crossing += cut.crossing;
        worst = std::max(worst, cut.seconds);
    }
    state.counters["triangles"] = double(mesh.triangle_count());
    state.counters["cut_ms"] = sum * 1e3 / kCutsInAChain;
    state.counters["worst_cut_ms"] = worst * 1e3;
    state.counters["ns_per_crossing"] = sum * 1e9 / crossing;
    state.counters["worst_to_predicted"] = worst_to_predicted(chain.cuts).to_predicted;
    state.counters["most_draw_ranges"] = double(chain.most_ranges);
}

/// Bytes of memory that the program has, what it has freed given back first. Addresses without memory don't count.
double resident_bytes()
{
    malloc_trim(0);
    std::ifstream statm("/proc/self/statm");
    double pages = 0.0, resident = 0.0;
    statm >> pages >> resident;
    return resident * double(sysconf(_SC_PAGESIZE));
}

/// What a program holds more of once it has prepared a copy of a mesh that it does not need any more. The median of a few
/// times: the first one of a program also touches what the next ones use again.
double bytes_of_prepared(const Mesh& mesh, const TimedBackEnd& back_end)
{
    constexpr int kTimes = 3;
    std::vector<double> bytes;
    for (int i = 0; i < kTimes; ++i) {
        const double before = resident_bytes();
        const Result<Object> result = back_end.prepare(value_of(mesh.clone()));
        bytes.push_back(resident_bytes() - before);
    }
    return core::median(std::move(bytes));
}

void prepare_shape(benchmark::State& state, const TimedBackEnd& back_end, const std::string& shape, std::uint64_t size)
{
    const Mesh& mesh = timed_shape(shape, size);
    {
        const Result<Object> checked = back_end.prepare(mesh);
        const std::string error = checked
                                      ? check_cut(*checked, planes_through_the_middle(mesh.bounds(), 1, kPlaneSeed)[0])
                                      : checked.reason();
        if (!error.empty()) return state.SkipWithError(error.c_str());
    }
    // Bytes are counted apart: that gives memory back, which the allocator of a program keeps (main.cpp).
    const double bytes = bytes_of_prepared(mesh, back_end);
    double seconds = 0.0;
    for (auto _ : state) {
        have_memory_for(mesh.triangle_count());
        Mesh copy = value_of(mesh.clone());
        core::CpuStopwatch watch;
        const Result<Object> result = back_end.prepare(std::move(copy));
        const double iteration = watch.lap();
        if (!result) return state.SkipWithError(result.reason());
        state.SetIterationTime(iteration);
        seconds += iteration;
    }
    const auto triangles = double(mesh.triangle_count());
    state.counters["triangles"] = triangles;
    state.counters["ns_per_triangle"] = seconds * 1e9 / double(state.iterations()) / triangles;
    state.counters["bytes_per_triangle"] = bytes / triangles;
}

/// The time that passes, of which the caller's processor time is a part.
void prepare_with_threads(benchmark::State& state, const TimedBackEnd& back_end, std::uint64_t size, unsigned threads)
{
    const Mesh& mesh = timed_shape("asteroid", size);
    double seconds = 0.0;
    for (auto _ : state) {
        have_memory_for(mesh.triangle_count());
        Mesh copy = value_of(mesh.clone());
        const auto start = std::chrono::steady_clock::now();
        const Result<Object> result = back_end.prepare(std::move(copy), threads);
        const std::chrono::duration<double> iteration = std::chrono::steady_clock::now() - start;
        if (!result) return state.SkipWithError(result.reason());
        state.SetIterationTime(iteration.count());
        seconds += iteration.count();
    }
    const auto triangles = double(mesh.triangle_count());
    state.counters["triangles"] = triangles;
    state.counters["ns_per_triangle"] = seconds * 1e9 / double(state.iterations()) / triangles;
}

}  // namespace

void register_chain_benchmarks()
{
    for (const TimedBackEnd& back_end : back_ends())
        if (back_end.name == "halfedge")
            for (const std::uint64_t size : {30'000ull, 100'000ull, 1'000'000ull})
                for (const unsigned threads : {1u, 2u})
                    benchmark::RegisterBenchmark(
                        ("PrepareThreads/" + std::to_string(threads) + "/halfedge/asteroid/" + std::to_string(size))
                            .c_str(),
                        [&back_end, size, threads](benchmark::State& s) {
                            prepare_with_threads(s, back_end, size, threads);
                        })
                        ->UseManualTime()
                        ->Unit(benchmark::kMillisecond);
    for (const std::uint64_t size : {10'000ull, 100'000ull, 1'000'000ull, 4'000'000ull})
        for (const TimedBackEnd& back_end : back_ends()) {
            const std::string tail = back_end.name + "/asteroid/" + std::to_string(size);
            // A chain of a hundred cuts with a lookup that is quadratic, or hashes every vertex, says nothing new; nor does
            // one of the largest mesh, or how a linear method prepares it.
            const bool is_largest = size > 1'000'000;
            if (back_end.name != "halfedge" && (is_largest || back_end.name != "baseline/remap")) continue;
            if (!is_largest)
                benchmark::RegisterBenchmark(
                    ("Recut/" + tail).c_str(),
                    [&back_end, size](benchmark::State& s) { recut(s, back_end, "asteroid", size); })
                    ->UseManualTime()
                    ->Unit(benchmark::kMillisecond);
            benchmark::RegisterBenchmark(
                ("Prepare/" + tail).c_str(),
                [&back_end, size](benchmark::State& s) { prepare_shape(s, back_end, "asteroid", size); })
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
}

}  // namespace kerf::bench
