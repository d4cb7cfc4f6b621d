// Meshes that are not round, with sections of many loops:
//   Real/<back end>/<mesh>        the two closed fragments with all attributes, nothing else
//   RealChain/<back end>/<mesh>   the whole chain that a game needs
//   ModelChain/<back end>/<model> the same of the report's fifteen models
// Scanned and modelled meshes are read from a folder beside the project, if it is there. In any case there are generated
// meshes of the same kinds: `folded`, a wall that is rolled up, and `tunnels`, a sponge.

#include <benchmark/benchmark.h>
#include <kerf/io.h>
#include <kerf/shapes.h>

#include <filesystem>
#include <string>
#include <utility>

#include "bench/back_ends.h"
#include "bench/models.h"
#include "bench/objects.h"
#include "bench/timed_cuts.h"
#include "bench/timed_shapes.h"

namespace kerf::bench {

namespace {

/// A mesh that is read or made when it is first asked for. The last one is kept: benchmarks of one follow one another.
struct RealMesh
{
    std::string name;
    std::string file;  ///< in the folder; empty: `shape` is made
    std::string shape;
    std::uint64_t triangles = 0;  ///< about so many
};

const Mesh& mesh_of(const RealMesh& real)
{
    static std::pair<std::string, Mesh> last;
    if (last.first != real.name) {
        last.second = {};
        last.second = real.file.empty()
                          ? value_of(make_shape(real.shape.c_str(), real.triangles))
                          : value_of(read_mesh((std::filesystem::path(KERF_SHARED_MESHES_DIR) / real.file).c_str()));
        last.first = real.name;
    }
    return last.second;
}

std::vector<RealMesh> meshes()
{
    std::vector<RealMesh> all;
    for (const auto& [name, file] : {std::pair("brain", "mni_t1iso60_804k.ply"), std::pair("skull", "skull.obj"),
                                     std::pair("cheese", "cheese.off"), std::pair("sponge", "mengerSponge3.glb")})
        if (std::filesystem::exists(std::filesystem::path(KERF_SHARED_MESHES_DIR) / file))
            all.push_back({name, file, ""});
    all.push_back({"folded", "", "spiral_wall", 100'000});
    all.push_back({"tunnels", "", "menger_sponge", 20'000});
    return all;
}

void register_one(const std::string& name, auto time)
{
    benchmark::RegisterBenchmark(name.c_str(), time)->UseManualTime()->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_real_benchmarks()
{
    constexpr std::uint64_t kMostForLoops = 100'000;  // comparing all vertices takes seconds beyond
    for (const RealMesh& real : meshes())
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
