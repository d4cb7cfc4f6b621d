// What a plane meets of an object that stays whole:
//   Section/loops/<back end>/asteroid/<triangles>   the loops in order, areas and lengths
//   Section/nested/<back end>/...                   and which loop lies in which
//   Section/filled/<back end>/...                   and the triangles that close them
//   Section/by_cut/<back end>/...                   the way without section(): cut a copy and look at its outline
// Random planes through the middle, those of Scale/. An iteration is one round over all planes; times per section are the
// iteration's divided by the counter `sections_each`.

#include <benchmark/benchmark.h>
#include <kerf/section.h>

#include <string>
#include <vector>

#include "bench/back_ends.h"
#include "bench/objects.h"
#include "bench/timed_shapes.h"

namespace kerf::bench {

namespace {

enum class Way : std::uint8_t
{
    loops,
    nested,
    filled,
    by_cut,
};

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

void time_sections(benchmark::State& state, const TimedBackEnd& back_end, std::uint64_t size, Way way)
{
    const Object& object = prepared(back_end, size);
    const std::vector<Plane> planes = planes_of_shape(timed_shape("asteroid", size));
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
            for (const auto& [name, way] : {std::pair("loops", Way::loops), std::pair("nested", Way::nested),
                                            std::pair("filled", Way::filled), std::pair("by_cut", Way::by_cut)}) {
                benchmark::RegisterBenchmark(
                    ("Section/" + std::string(name) + "/" + back_end.name + "/asteroid/" + std::to_string(size))
                        .c_str(),
                    [&back_end, size, way = way](benchmark::State& s) { time_sections(s, back_end, size, way); })
                    ->Unit(benchmark::kMillisecond);
            }
        }
}

}  // namespace kerf::bench
