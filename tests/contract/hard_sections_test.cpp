// What cuts cost at worst: sixteen times the section is sixteen times as much to look at, to write and to remember, as
// counters say exactly. What no counter sees is left to the time: it may take some more than sixteen times as long, but
// not 256 times. Times of one run are compared with one another, never with a clock.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "baseline/report_costs.h"
#include "common/mesh/plane_frame.h"
#include "common/shapes/hard_sections.h"
#include "common/support/cpu_stopwatch.h"
#include "support/allocations.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

constexpr std::uint32_t kGrowth = 16;
/// Linear time, caches that no longer hold it, n log n and a neighbour's noise stay below n^1.5: 36 was the most of one
/// run, and 51 of another, on a machine with six times as much to do as it has cores.
constexpr double kMostGrowth = 64.0;
/// What is over sooner than this many seconds is not measured but taken for this long.
constexpr double kShortest = 2e-4;

/// Seconds that the steps take: the least of some runs.
struct Seconds
{
    double repair = 1e9, prepare = 1e9, cut = 1e9, pieces = 1e9, again = 1e9;
};

/// Through the middle of what was cut, at right angles to the first plane.
Plane second_plane(const Cuttable& object, const Plane& first)
{
    const PlaneFrame frame = PlaneFrame::of(first.normal);
    return *Plane::through(object.bounds().centre(), frame.u + 0.25 * frame.v);
}

template <class Step>
auto timed(double& least, Step step)
{
    CpuStopwatch watch;
    auto result = step();
    least = std::min(least, std::max(kShortest, watch.lap()));
    return result;
}

Seconds measure(const Backend& backend, const std::string& name, std::uint32_t size, int runs)
{
    Seconds seconds;
    CutOptions in_pieces;
    in_pieces.split_components = true;
    const shapes::HardSection section = *shapes::hard_section(name, size);
    for (int run = 0; run < runs; ++run) {
        TriangleSoup soup = section.soup;
        const IndexedMesh mesh = timed(seconds.repair, [&] { return test::repaired(std::move(soup)); });
        IndexedMesh copy = mesh;
        PrepareResult prepared = timed(seconds.prepare, [&] { return backend.prepare(std::move(copy)); });
        auto clone = prepared.object->clone();
        CutResult sides = timed(seconds.cut, [&] { return cut(std::move(clone), section.plane); });
        EXPECT_EQ(sides.status, Status::done);
        if (sides.status != Status::done) break;
        timed(seconds.pieces, [&] { return cut(std::move(prepared.object), section.plane, in_pieces); });
        auto& half = sides.positive.front();
        const Plane second = second_plane(*half, section.plane);
        timed(seconds.again, [&] { return cut(std::move(half), second, in_pieces); });
    }
    return seconds;
}

std::vector<test::NamedBackend> fastest_backends()
{
    std::vector<test::NamedBackend> result;
    for (const test::NamedBackend& backend : test::backends())
        if (backend.name == "baseline_remap" || backend.name == "halfedge") result.push_back(backend);
    return result;
}

class HardSection : public testing::TestWithParam<std::string>
{
};

enum class Kind
{
    flat,
    one_loop,
    many_loops
};

Kind kind_of(const std::string& name)
{
    if (name.starts_with("flat")) return Kind::flat;
    for (const char* one : {"comb", "leaning_comb", "spiral", "tip", "toothed_tip", "touches"})
        if (name == one) return Kind::one_loop;
    return Kind::many_loops;
}

std::uint32_t small_size(const std::string& name)
{
    const Kind kind = kind_of(name);
    return kind == Kind::flat ? 2'000 : kind == Kind::one_loop ? 1'000 : 150;
}

/// What a step asks for.
struct Memory
{
    double allocations = 0, bytes = 0;
};

template <class Step>
auto remembered(Memory& memory, Step step)
{
    const std::uint64_t calls = test::allocations();
    const std::size_t bytes = test::allocated_bytes();
    auto result = step();
    memory = {double(test::allocations() - calls), double(test::allocated_bytes() - bytes)};
    return result;
}

/// The steps of measure(), counted.
struct Counts
{
    Memory repair, prepare, cut, pieces, again;
    CutStatistics cut_statistics, pieces_statistics, again_statistics;
};

Counts count(const Backend& backend, const std::string& name, std::uint32_t size)
{
    Counts counts;
    CutOptions in_pieces;
    in_pieces.split_components = true;
    shapes::HardSection section = *shapes::hard_section(name, size);
    IndexedMesh mesh = remembered(counts.repair, [&] { return test::repaired(std::move(section.soup)); });
    auto object = remembered(counts.prepare, [&] { return backend.prepare(std::move(mesh)).object; });
    auto clone = object->clone();
    CutResult sides = remembered(counts.cut, [&] { return cut(std::move(clone), section.plane); });
    counts.cut_statistics = sides.statistics;
    counts.pieces_statistics =
        remembered(counts.pieces, [&] { return cut(std::move(object), section.plane, in_pieces); }).statistics;
    if (sides.positive.empty()) return counts;
    auto& half = sides.positive.front();
    const Plane second = second_plane(*half, section.plane);
    counts.again_statistics =
        remembered(counts.again, [&] { return cut(std::move(half), second, in_pieces); }).statistics;
    return counts;
}

/// Most that a counter may grow, sixteen times the size: a logarithm and what is there in any case are in it.
constexpr double kMostCounted = 20.0;

/// Most that a cut asks for, for each triangle that it touches: what is asked for only when reserved room is used up
/// can't be compared between two sizes. Most of it is asked for by pieces of a few triangles each.
Memory budget(const std::string& backend)
{
    return backend == "halfedge" ? Memory{8, 1500} : Memory{18, 5500};
}

TEST_P(HardSection, CountsNoMoreThanItsSizeSays)
{
    const std::uint32_t size = small_size(GetParam());
    const auto expect_growth = [](double small, double large) { EXPECT_LE(large, kMostCounted * small); };
    for (const test::NamedBackend& named : fastest_backends()) {
        SCOPED_TRACE(named.name);
        const auto backend = named.make();
        const Counts small = count(*backend, GetParam(), size), large = count(*backend, GetParam(), kGrowth * size);
        expect_growth(small.repair.allocations, large.repair.allocations);
        expect_growth(small.repair.bytes, large.repair.bytes);
        expect_growth(small.prepare.allocations, large.prepare.allocations);
        expect_growth(small.prepare.bytes, large.prepare.bytes);
        const Memory most = budget(named.name);
        const auto expect_cut = [&](const CutStatistics& a, const CutStatistics& b, const Memory& memory) {
            ASSERT_GT(b.triangles_touched, 0u);
            expect_growth(double(a.triangles_touched), double(b.triangles_touched));
            expect_growth(double(a.nodes_visited), double(b.nodes_visited));
            expect_growth(double(a.bytes_to_upload), double(b.bytes_to_upload));
            // A small section may be closed in an easier way: fewer steps than this for each triangle are none.
            constexpr std::uint64_t kFewSteps = 16;
            expect_growth(double(std::max(a.cap_steps, kFewSteps * a.triangles_touched)), double(b.cap_steps));
            EXPECT_LE(memory.allocations, most.allocations * double(b.triangles_touched));
            EXPECT_LE(memory.bytes, most.bytes * double(b.triangles_touched));
        };
        expect_cut(small.cut_statistics, large.cut_statistics, large.cut);
        expect_cut(small.pieces_statistics, large.pieces_statistics, large.pieces);
        expect_cut(small.again_statistics, large.again_statistics, large.again);
    }
}

TEST_P(HardSection, ComparesNoMoreVerticesThanItsSizeSays)
{
    const std::uint32_t size = small_size(GetParam());
    for (const test::NamedBackend& named : test::backends()) {
        if (named.name != "baseline_hash") continue;
        const auto backend = named.make();
        const auto compared = [&](std::uint32_t n) {
            const shapes::HardSection section = *shapes::hard_section(GetParam(), n);
            auto object = backend->prepare(test::repaired(section.soup)).object;
            return double(baseline::report_costs(cut(std::move(object), section.plane)).vertex_comparisons);
        };
        const double small = compared(size);
        EXPECT_GT(small, 0.0);
        EXPECT_LE(compared(kGrowth * size), kMostCounted * small);
    }
}

TEST_P(HardSection, CostsNoMoreThanItsSizeSays)
{
    const std::uint32_t size = small_size(GetParam());
    for (const test::NamedBackend& named : fastest_backends()) {
        const auto backend = named.make();
        const Seconds small = measure(*backend, GetParam(), size, 6),
                      large = measure(*backend, GetParam(), kGrowth * size, 4);
        SCOPED_TRACE(named.name);
        EXPECT_LE(large.prepare, kMostGrowth * small.prepare);
        EXPECT_LE(large.cut, kMostGrowth * small.cut);
        EXPECT_LE(large.pieces, kMostGrowth * small.pieces);
        EXPECT_LE(large.again, kMostGrowth * small.again);
    }
}

TEST_P(HardSection, IsClosedAndTheSameForBothBackEnds)
{
    const shapes::HardSection section = *shapes::hard_section(GetParam(), 400);
    const IndexedMesh mesh = test::repaired(section.soup);
    ASSERT_EQ(referee::open_edges(mesh), 0u);
    const double whole = referee::volume(mesh);
    for (const bool in_pieces : {false, true}) {
        std::vector<CutResult> results;
        for (const test::NamedBackend& named : fastest_backends()) {
            SCOPED_TRACE(named.name + (in_pieces ? ", in pieces" : ""));
            CutOptions options;
            options.split_components = in_pieces;
            results.push_back(cut(named.make()->prepare(mesh).object, section.plane, options));
            const CutResult& result = results.back();
            ASSERT_EQ(result.status, Status::done);
            double volume = 0.0;
            for (const auto* side : {&result.negative, &result.positive})
                for (const auto& fragment : *side) {
                    const IndexedMesh piece = fragment->to_indexed_mesh();
                    EXPECT_EQ(referee::open_edges(piece), 0u);
                    EXPECT_EQ(referee::triangles_with_equal_corners(piece), 0u);
                    volume += referee::volume(piece);
                }
            EXPECT_NEAR(volume, whole, 1e-6 * whole);
            EXPECT_EQ(result.negative.size(), results.front().negative.size());
            EXPECT_EQ(result.positive.size(), results.front().positive.size());
            EXPECT_EQ(referee::canonical_surface(result.negative),
                      referee::canonical_surface(results.front().negative));
            EXPECT_EQ(referee::canonical_surface(result.positive),
                      referee::canonical_surface(results.front().positive));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, HardSection, testing::ValuesIn(shapes::hard_section_names()),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace kerf::core
