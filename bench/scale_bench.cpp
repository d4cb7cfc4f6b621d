// How the cost of one cut grows with the mesh:
//   Scale/<back end>/<shape>/<triangles>     the whole chain that a game needs: two closed fragments, mass properties,
//                                            a bounded hull each, and the draw view with the bytes to upload
//   Geometry/<back end>/<shape>/<triangles>  the two closed fragments with all attributes, nothing else
// Shapes: `asteroid` (triangles in a coherent order) and `shuffled` (the same in a random order). Random planes through
// the middle.

#include <benchmark/benchmark.h>

#include "bench/back_ends.h"
#include "bench/timed_cuts.h"
#include "bench/timed_shapes.h"

namespace kerf::bench {

namespace {

constexpr std::uint64_t kMostShuffled = 1'000'000, kMostShuffledDictionary = 300'000;  // above: seconds a cut
constexpr std::uint64_t kMostDictionaryGeometry = 1'000'000;

}  // namespace

void register_scale_benchmarks()
{
    for (const std::uint64_t size :
         {1'000ull, 3'000ull, 10'000ull, 30'000ull, 100'000ull, 300'000ull, 1'000'000ull, 4'000'000ull, 16'000'000ull})
        for (const std::string shape : {"asteroid", "shuffled"})
            for (const TimedBackEnd& back_end : back_ends())
                for (const Extent extent : {Extent::whole_chain, Extent::geometry}) {
                    if (size > back_end.most_triangles) continue;
                    const bool dictionary = back_end.name == "baseline/hash";
                    // Nearly all of a dictionary's whole chain is the geometry: the largest is timed once.
                    if (dictionary && extent == Extent::geometry && size > kMostDictionaryGeometry) continue;
                    if (shape == "shuffled" && size > (dictionary ? kMostShuffledDictionary : kMostShuffled)) continue;
                    const std::string name = (extent == Extent::geometry ? "Geometry/" : "Scale/") + back_end.name +
                                             "/" + shape + "/" + std::to_string(size);
                    benchmark::RegisterBenchmark(name.c_str(),
                                                 [&back_end, shape, size, extent](benchmark::State& s) {
                                                     const Mesh& mesh = timed_shape(shape, size);
                                                     time_cuts(s, back_end, mesh, shape, planes_of_shape(mesh), extent);
                                                 })
                        ->UseManualTime()
                        ->Unit(benchmark::kMillisecond);
                }
}

}  // namespace kerf::bench
