// Many sections of an object that stays whole, of planes across z at even distances through all of its height:
//   Stack/<back end>/asteroid/<triangles>/<heights>   loops in order, areas, lengths and nesting, on one thread
//   StackThreads/2/halfedge/asteroid/1000000/1000     the same on two threads: the time that passes
//   RealStack/<back end>/<mesh>/<heights>             of a mesh that is not round
// and one section of such a mesh, where an iteration is one round over five planes:
//   RealSection/<back end>/<mesh>

#include <benchmark/benchmark.h>
#include <kerf/section.h>

#include <cmath>
#include <string>
#include <vector>

#include "bench/back_ends.h"
#include "bench/objects.h"
#include "bench/real_meshes.h"
#include "bench/timed_shapes.h"

namespace kerf::bench {

namespace {

const Normal kUp{0, 0, 1};

std::vector<double> even_heights(const Mesh& mesh, std::size_t count)
{
    const double lowest = mesh.bounds().lo.z, step = (mesh.bounds().hi.z - lowest) / double(count);
    std::vector<double> heights;
    for (std::size_t i = 0; i < count; ++i) heights.push_back(lowest + (double(i) + 0.5) * step);
    return heights;
}

/// What is wrong with a stack, or "": its volume is that of the mesh, about, if the mesh is closed.
std::string fault_of(const SectionStack& stack, const Mesh& mesh, const Object& object, double step)
{
    constexpr std::size_t kFew = 50;       // sections of a mesh: their sum is no good estimate
    constexpr double kVolumeShare = 0.02;  // what the sum over even heights leaves
    double volume = 0.0;
    for (const Section& section : stack.all()) volume += section.area * step;
    const double expected = object.mass_properties().volume;
    const bool is_known = mesh.is_closed() && stack.all().size() > kFew;
    return !is_known || std::abs(volume - expected) <= kVolumeShare * std::abs(expected) ? "" : "not the mesh's volume";
}

void time_stack(benchmark::State& state, const TimedBackEnd& back_end, const Mesh& mesh, std::size_t count,
                unsigned threads)
{
    const Object object = value_of(back_end.prepare(mesh));
    const std::vector<double> heights = even_heights(mesh, count);
    StackOptions options;
    options.threads = threads;
    SectionStack stack;
    if (sections(object, kUp, heights, stack, options) != Status::done) return state.SkipWithError(stack.reason());
    const double step = (mesh.bounds().hi.z - mesh.bounds().lo.z) / double(count);
    if (const std::string fault = fault_of(stack, mesh, object, step); !fault.empty())
        return state.SkipWithError(fault.c_str());
    double crossing = 0.0, loops = 0.0;
    for (const Section& section : stack.all()) {
        crossing += double(section.statistics().crossing_triangles);
        loops += double(section.path_count());
    }
    for (auto _ : state) benchmark::DoNotOptimize(sections(object, kUp, heights, stack, options));
    state.counters["triangles"] = double(mesh.triangle_count());
    state.counters["heights"] = double(count);
    state.counters["crossing_triangles"] = crossing;
    state.counters["loops"] = loops;
}

void time_real_section(benchmark::State& state, const TimedBackEnd& back_end, const Mesh& mesh)
{
    const Object object = value_of(back_end.prepare(mesh));
    const std::vector<Plane> planes = planes_of_shape(mesh);
    Section found;
    double crossing = 0.0, loops = 0.0;
    for (const Plane& plane : planes) {
        if (!ok(section(object, plane, found))) return state.SkipWithError(found.reason());
        crossing += double(found.statistics().crossing_triangles);
        loops += double(found.path_count());
    }
    for (auto _ : state)
        for (const Plane& plane : planes) benchmark::DoNotOptimize(section(object, plane, found));
    const auto count = double(planes.size());
    state.counters["sections_each"] = count;
    state.counters["triangles"] = double(mesh.triangle_count());
    state.counters["crossing_triangles"] = crossing / count;
    state.counters["loops"] = loops / count;
}

void register_stack(const std::string& name, auto time)
{
    benchmark::RegisterBenchmark(name.c_str(), time)->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_stack_benchmarks()
{
    constexpr std::uint64_t kMillion = 1'000'000;
    for (const std::uint64_t size : {10'000ull, 100'000ull, 1'000'000ull, 4'000'000ull})
        for (const TimedBackEnd& back_end : back_ends()) {
            if (size > back_end.most_triangles || back_end.differs_in_caps_only()) continue;
            for (const std::size_t heights : {10, 100, 1000}) {
                const std::string tail = "asteroid/" + std::to_string(size) + "/" + std::to_string(heights);
                register_stack("Stack/" + back_end.name + "/" + tail, [&back_end, size, heights](benchmark::State& s) {
                    time_stack(s, back_end, timed_shape("asteroid", size), heights, 1);
                });
                if (back_end.name == "halfedge" && size == kMillion)
                    benchmark::RegisterBenchmark(("StackThreads/2/halfedge/" + tail).c_str(),
                                                 [&back_end, size, heights](benchmark::State& s) {
                                                     time_stack(s, back_end, timed_shape("asteroid", size), heights, 2);
                                                 })
                        ->UseRealTime()
                        ->Unit(benchmark::kMillisecond);
            }
        }
    for (const RealMesh& real : real_meshes())
        for (const TimedBackEnd& back_end : back_ends()) {
            if (back_end.name != "halfedge" && back_end.name != "baseline/remap") continue;
            register_stack("RealSection/" + back_end.name + "/" + real.name,
                           [&back_end, real](benchmark::State& s) { time_real_section(s, back_end, mesh_of(real)); });
            register_stack("RealStack/" + back_end.name + "/" + real.name + "/100",
                           [&back_end, real](benchmark::State& s) { time_stack(s, back_end, mesh_of(real), 100, 1); });
        }
}

}  // namespace kerf::bench
