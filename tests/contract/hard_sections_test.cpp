// What cuts cost at worst: sixteen times the section may take some more than sixteen times as long, but not 256 times.
// Times of one run are compared with one another, never with a clock.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "common/cpu_stopwatch.h"
#include "common/shapes/hard_sections.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf {
namespace {

constexpr std::uint32_t kGrowth = 16;
/// Linear time, caches that no longer hold it, n log n and a neighbour's noise stay below n^1.5.
constexpr double kMostGrowth = 64.0;
/// What is over sooner than this many seconds is not measured but taken for this long.
constexpr double kShortest = 2e-4;

/// Seconds that the steps take: the least of some runs.
struct Seconds
{
    double assemble = 1e9, prepare = 1e9, cut = 1e9, pieces = 1e9, again = 1e9;
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
        const IndexedMesh mesh = timed(seconds.assemble, [&] { return test::assembled(std::move(soup)); });
        IndexedMesh copy = mesh;
        PrepareResult prepared = timed(seconds.prepare, [&] { return backend.prepare(std::move(copy)); });
        auto clone = prepared.object->clone();
        CutResult sides = timed(seconds.cut, [&] { return cut(std::move(clone), section.plane); });
        EXPECT_EQ(sides.status, Status::cut);
        if (sides.status != Status::cut) break;
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

TEST_P(HardSection, CostsNoMoreThanItsSizeSays)
{
    const bool is_flat = GetParam().starts_with("flat");
    const bool is_one_loop = GetParam() == "comb" || GetParam() == "leaning_comb" || GetParam() == "spiral";
    const std::uint32_t size = is_flat ? 2'000 : is_one_loop ? 1'000 : 150;
    for (const test::NamedBackend& named : fastest_backends()) {
        const auto backend = named.make();
        const Seconds small = measure(*backend, GetParam(), size, 5),
                      large = measure(*backend, GetParam(), kGrowth * size, 2);
        SCOPED_TRACE(named.name);
        EXPECT_LE(large.assemble, kMostGrowth * small.assemble);
        EXPECT_LE(large.prepare, kMostGrowth * small.prepare);
        EXPECT_LE(large.cut, kMostGrowth * small.cut);
        EXPECT_LE(large.pieces, kMostGrowth * small.pieces);
        EXPECT_LE(large.again, kMostGrowth * small.again);
    }
}

TEST_P(HardSection, IsClosedAndTheSameForBothBackEnds)
{
    const shapes::HardSection section = *shapes::hard_section(GetParam(), 400);
    const IndexedMesh mesh = test::assembled(section.soup);
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
            ASSERT_EQ(result.status, Status::cut);
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
}  // namespace kerf
