// Meshes that are not round, with sections of many loops:
//   Real/<back end>/<mesh>        the two closed fragments with all attributes, nothing else
//   RealChain/<back end>/<mesh>   the whole chain that a game needs
//   ModelChain/<back end>/<model> the same of the report's fifteen models

#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "bench/back_ends.h"
#include "bench/models.h"
#include "bench/real_meshes.h"
#include "bench/timed_cuts.h"
#include "bench/timed_shapes.h"

namespace kerf::bench {

namespace {

void register_one(const std::string& name, auto time)
{
    benchmark::RegisterBenchmark(name.c_str(), time)->UseManualTime()->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_real_benchmarks()
{
    constexpr std::uint64_t kMostForLoops = 100'000;  // comparing all vertices takes seconds beyond
    for (const RealMesh& real : real_meshes())
        for (const TimedBackEnd& back_end : back_ends())
            for (const auto& [prefix, extent] :
                 {std::pair("Real/", Extent::geometry), std::pair("RealChain/", Extent::whole_chain)}) {
                if (back_end.most_triangles < kMostForLoops) continue;
                register_one(prefix + back_end.name + "/" + real.name,
                             [&back_end, real, extent = extent](benchmark::State& state) {
                                 const Mesh& mesh = mesh_of(real);
                                 time_cuts(state, back_end, mesh, real.name, planes_of_shape(mesh), extent);
                             });
            }
    for (const Model& model : models())
        for (const TimedBackEnd& back_end : back_ends())
            register_one(
                "ModelChain/" + back_end.name + "/" + model.name, [&back_end, &model](benchmark::State& state) {
                    time_cuts(state, back_end, model.mesh, model.name, planes_of_model(model), Extent::whole_chain);
                });
}

}  // namespace kerf::bench
