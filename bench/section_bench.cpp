// What a plane meets of an object that stays whole:
//   Section/loops/<back end>/asteroid/<triangles>   the loops in order, areas and lengths
//   Section/nested/<back end>/...                   and which loop lies in which
//   Section/filled/<back end>/...                   and the triangles that close them
//   Section/by_cut/<back end>/...                   the way without section(): cut a copy and look at its outline
// Random planes through the middle, those of Scale/, and of the half-edge back end also loops by planes that
//   Section/through_vertices/...                    pass three vertices
//   Section/along_edges/...                         pass both ends of an edge and a vertex
//   Section/in_faces/...                            pass the three corners of a triangle
// which are rounded, as all positions are: some of these points lie on the plane, others a little off. An iteration is one round over all planes; times per section are the
// iteration's divided by the counter `sections_each`.

#include <benchmark/benchmark.h>
#include <kerf/section.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/back_ends.h"
#include "bench/objects.h"
#include "bench/timed_shapes.h"
#include "common/support/random.h"

namespace kerf::bench {

namespace {

enum class Way : std::uint8_t
{
    loops,
    nested,
    filled,
    by_cut,
};

/// How many corners of one triangle a plane passes, the rest of its three points being corners of others. 0: none, but the
/// middle.
struct Through
{
    std::uint32_t corners = 0;
};

std::vector<Plane> planes_through(const Object& object, const Mesh& mesh, Through through)
{
    if (through.corners == 0) return planes_of_shape(mesh);
    constexpr std::uint64_t kSeed = 21;
    constexpr std::size_t kPlanes = 20;
    core::Random random(kSeed);
    const MeshArrays arrays = mesh.arrays();
    const auto triangle = [&] { return static_cast<std::size_t>(random.unit() * double(mesh.triangle_count())); };
    std::vector<Plane> planes;
    Section found;
    while (planes.size() < kPlanes) {
        const std::size_t first = triangle();
        std::array<Vec3d, 3> p;
        for (std::uint32_t c = 0; c < 3; ++c)
            p[c] = Vec3d(arrays.positions[arrays.indices[3 * (c < through.corners ? first : triangle()) + c]]);
        const std::optional<Plane> plane = Plane::through(p[0], p[1], p[2]);
        if (plane && ok(section(object, *plane, found))) planes.push_back(*plane);
    }
    return planes;
}

/// The object that was asked for last: benchmarks of one follow one another.
const Object& prepared(const TimedBackEnd& back_end, std::uint64_t size)
{
    static std::string last_name;
    static Object last;
    const std::string name = back_end.name + std::to_string(size);
    if (last_name != name) {
        last = {};
        last = value_of(back_end.prepare(timed_shape("asteroid", size)));
        last_name = name;
    }
    return last;
}

/// What is wrong with a section, or "": a cut is its referee.
std::string fault_of(const Object& object, const Plane& plane, const Section& section)
{
    const Cut cut = cut_copy(object, plane);
    if (section.status != cut.status) return "the status is not that of a cut";
    if (section.area != cut.section_area) return "the area is not that of a cut";
    if (section.path_count() != cut.statistics().section_loops) return "the loops are not those of a cut";
    return "";
}

SectionOptions options_of(Way way)
{
    SectionOptions options;
    options.nesting = way != Way::loops;
    options.fill = way == Way::filled;
    return options;
}

void time_sections(benchmark::State& state, const TimedBackEnd& back_end, std::uint64_t size, Way way, Through through)
{
    const Object& object = prepared(back_end, size);
    const std::vector<Plane> planes = planes_through(object, timed_shape("asteroid", size), through);
    const SectionOptions options = options_of(way);
    Section found;
    double crossing = 0.0, touched = 0.0, nodes = 0.0;
    for (const Plane& plane : planes) {
        if (!ok(section(object, plane, found, options))) return state.SkipWithError(found.reason());
        if (const std::string fault = fault_of(object, plane, found); !fault.empty())
            return state.SkipWithError(fault.c_str());
        crossing += double(found.statistics().crossing_triangles);
        touched += double(found.statistics().triangles_touched);
        nodes += double(found.statistics().nodes_visited);
    }
    for (auto _ : state)
        for (const Plane& plane : planes) {
            if (way == Way::by_cut) {
                Cut cut = cut_copy(object, plane);
                benchmark::DoNotOptimize(cut.one(Side::positive)->loop(0).points.data());
            } else {
                benchmark::DoNotOptimize(section(object, plane, found, options));
            }
        }
    const auto count = double(planes.size());
    state.counters["sections_each"] = count;
    state.counters["triangles"] = double(object.triangle_count());
    state.counters["crossing_triangles"] = crossing / count;
    state.counters["triangles_touched"] = touched / count;
    state.counters["nodes_visited"] = nodes / count;
}

}  // namespace

void register_section_benchmarks()
{
    for (const std::uint64_t size : {10'000ull, 100'000ull, 1'000'000ull, 4'000'000ull})
        for (const TimedBackEnd& back_end : back_ends()) {
            if (size > back_end.most_triangles || back_end.differs_in_caps_only()) continue;
            const auto add = [&](const char* name, Way way, Through through) {
                benchmark::RegisterBenchmark(
                    ("Section/" + std::string(name) + "/" + back_end.name + "/asteroid/" + std::to_string(size))
                        .c_str(),
                    [&back_end, size, way, through](benchmark::State& s) {
                        time_sections(s, back_end, size, way, through);
                    })
                    ->Unit(benchmark::kMillisecond);
            };
            for (const auto& [name, way] : {std::pair("loops", Way::loops), std::pair("nested", Way::nested),
                                            std::pair("filled", Way::filled), std::pair("by_cut", Way::by_cut)})
                add(name, way, {});
            if (back_end.name != "halfedge") continue;
            add("through_vertices", Way::loops, {1});
            add("along_edges", Way::loops, {2});
            add("in_faces", Way::loops, {3});
        }
}

}  // namespace kerf::bench
