// From the arrays of a program to an object that can be cut:
//   FromArrays/<back end>/<shape>/<triangles>  Mesh::make() of positions, normals, uv and indices, then prepare();
//                                              counters: either part, and both for each triangle

#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "bench/back_ends.h"
#include "bench/machine_memory.h"
#include "bench/objects.h"
#include "bench/timed_shapes.h"
#include "common/support/cpu_stopwatch.h"

namespace kerf::bench {

namespace {

MeshInput input_of(const Mesh& mesh)
{
    const MeshArrays arrays = mesh.arrays();
    MeshInput input;
    input.positions = &arrays.positions[0].x;
    input.vertex_count = arrays.positions.size();
    input.normals = &arrays.normals[0].x;
    input.uvs = &arrays.uvs[0].x;
    input.indices = arrays.indices.data();
    input.triangle_count = arrays.indices.size() / 3;
    return input;
}

void from_arrays(benchmark::State& state, const TimedBackEnd& back_end, const std::string& shape, std::uint64_t size)
{
    const Mesh& mesh = timed_shape(shape, size);
    const MeshInput input = input_of(mesh);
    double make = 0.0, prepare = 0.0;
    for (auto _ : state) {
        have_memory_for(mesh.triangle_count());
        core::CpuStopwatch watch;
        Result<Mesh> made = Mesh::make(input);
        const double make_time = watch.lap();
        const Result<Object> object = back_end.prepare(*std::move(made));
        const double prepare_time = watch.lap();
        if (!object || object->triangle_count() != mesh.triangle_count())
            return state.SkipWithError("the object has not the triangles of the arrays");
        state.SetIterationTime(make_time + prepare_time);
        make += make_time;
        prepare += prepare_time;
    }
    const auto iterations = double(state.iterations()), triangles = double(mesh.triangle_count());
    state.counters["triangles"] = triangles;
    state.counters["make_ms"] = make * 1e3 / iterations;
    state.counters["prepare_ms"] = prepare * 1e3 / iterations;
    state.counters["ns_per_triangle"] = (make + prepare) * 1e9 / iterations / triangles;
}

}  // namespace

void register_arrays_benchmarks()
{
    for (const std::uint64_t size : {1'000ull, 10'000ull, 100'000ull, 1'000'000ull})
        for (const TimedBackEnd& back_end : back_ends()) {
            if (back_end.differs_in_caps_only()) continue;
            benchmark::RegisterBenchmark(
                ("FromArrays/" + back_end.name + "/asteroid/" + std::to_string(size)).c_str(),
                [&back_end, size](benchmark::State& s) { from_arrays(s, back_end, "asteroid", size); })
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
}

}  // namespace kerf::bench
