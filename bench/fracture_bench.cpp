// An object broken into the cells of points, anywhere in it:
//   Fracture/<back end>/asteroid/<triangles>/<cells>   fracture() of a prepared object, pieces' preparing included
//   RealFracture/<back end>/<mesh>/<cells>             of a mesh that is not round

#include <benchmark/benchmark.h>
#include <kerf/fracture.h>

#include <cmath>
#include <string>

#include "bench/back_ends.h"
#include "bench/objects.h"
#include "bench/real_meshes.h"
#include "bench/timed_shapes.h"

namespace kerf::bench {

namespace {

/// What is wrong with the pieces, or "".
std::string fault_of(Fracture& fracture, double volume)
{
    constexpr double kVolumeShare = 1e-6;
    double sum = 0.0;
    for (std::size_t i = 0; const Object* const piece = fracture.piece(i); ++i) {
        const MassProperties mass = piece->mass_properties();
        if (!mass.is_of_solid) return "a piece is open";
        sum += mass.volume;
    }
    return std::abs(sum - volume) <= kVolumeShare * volume ? "" : "the pieces' volumes are not that of the object";
}

void time_fracture(benchmark::State& state, const TimedBackEnd& back_end, const Mesh& mesh, std::uint32_t cells)
{
    const Object object = value_of(back_end.prepare(mesh));
    FractureOptions options;
    options.cells = cells;
    options.seed = 1;
    Fracture fracture = kerf::fracture(object, options);
    if (!ok(fracture.status())) return state.SkipWithError(fracture.reason());
    if (const std::string fault = fault_of(fracture, object.mass_properties().volume); !fault.empty())
        return state.SkipWithError(fault.c_str());
    double triangles = 0.0, contact_area = 0.0;
    for (std::size_t i = 0; const Object* const piece = fracture.piece(i); ++i)
        triangles += double(piece->triangle_count());
    for (const FractureBond& bond : fracture.bonds()) contact_area += bond.area;
    state.counters["triangles"] = double(mesh.triangle_count());
    state.counters["cells"] = double(cells);
    state.counters["pieces"] = double(fracture.count());
    state.counters["bonds"] = double(fracture.bonds().size());
    state.counters["contact_area"] = contact_area;
    state.counters["piece_triangles"] = triangles;
    for (auto _ : state) {
        fracture = {};
        fracture = kerf::fracture(object, options);
    }
}

void register_fracture(const std::string& name, auto time)
{
    benchmark::RegisterBenchmark(name.c_str(), time)->Unit(benchmark::kMillisecond);
}

bool is_timed(const TimedBackEnd& back_end)
{
    return back_end.name == "halfedge" || back_end.name == "linear";
}

}  // namespace

void register_fracture_benchmarks()
{
    for (const TimedBackEnd& back_end : back_ends()) {
        if (!is_timed(back_end)) continue;
        for (const std::uint32_t cells : {10u, 100u, 1000u}) {
            std::string tail("/");
            tail += std::to_string(cells);
            for (const std::uint64_t size : {10'000ull, 100'000ull, 1'000'000ull})
                register_fracture("Fracture/" + back_end.name + "/asteroid/" + std::to_string(size) + tail,
                                  [&back_end, size, cells](benchmark::State& s) {
                                      time_fracture(s, back_end, timed_shape("asteroid", size), cells);
                                  });
            for (const RealMesh& real : real_meshes())
                register_fracture("RealFracture/" + back_end.name + "/" + real.name + tail,
                                  [&back_end, real, cells](benchmark::State& s) {
                                      time_fracture(s, back_end, mesh_of(real), cells);
                                  });
        }
    }
}

}  // namespace kerf::bench
