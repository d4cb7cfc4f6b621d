// The proof that a cut costs what its section costs: exact counters, and what it asks of memory.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/shapes/shapes.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "halfedge/universe/cut_reserve.h"
#include "support/allocations.h"
#include "support/fixtures.h"
#include "support/sanitized.h"
#include "support/touched_memory.h"

namespace kerf::core::halfedge {
namespace {

// For each crossing triangle of an asteroid that is whole.
constexpr double kTriangles = 20, kBytes = 300, kNodes = 2.5;
constexpr double kExponent = 0.56;

struct Sample
{
    double triangles = 0, touched = 0, bytes = 0, nodes = 0;
};

Sample measure(std::uint64_t triangles)
{
    const auto object = std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(triangles, 1))).object);
    test::Random random(9);
    Sample sum;
    sum.triangles = double(object->triangle_count());
    for (int i = 0; i < 5; ++i) {
        const Plane plane = *Plane::through(0.1 * random.direction(), random.direction());
        const CutResult result = cut(object->clone(), plane);
        EXPECT_EQ(result.status, Status::done);
        const CutStatistics& s = result.statistics;
        const double k = double(s.crossing_triangles);
        EXPECT_LE(double(s.triangles_touched), kTriangles * k);
        EXPECT_LE(double(s.bytes_to_upload), kBytes * k);
        EXPECT_LE(double(s.nodes_visited), kNodes * k);
        EXPECT_EQ(s.bytes_grown, 0u);
        sum.touched += double(s.triangles_touched);
        sum.bytes += double(s.bytes_to_upload);
        sum.nodes += double(s.nodes_visited);
    }
    return sum;
}

TEST(Growth, CountersGrowAsTheSectionDoes)
{
    const Sample small = measure(10'000), large = measure(400'000);
    measure(1000);
    measure(1'000'000);
    const double decades = std::log(large.triangles / small.triangles);
    EXPECT_LE(std::log(large.touched / small.touched) / decades, kExponent);
    EXPECT_LE(std::log(large.bytes / small.bytes) / decades, kExponent);
    EXPECT_LE(std::log(large.nodes / small.nodes) / decades, kExponent);
}

TEST(Growth, ACutAllocatesInProportionToItsSection)
{
    // At most this many bytes for each crossing triangle, and no single request that is in proportion to the mesh.
    constexpr double kAllocated = 4000;
    for (const std::uint64_t n : {20'000u, 320'000u}) {
        auto object = std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(n, 1))).object);
        const Plane plane = *Plane::through({0.01, 0.02, 0.03}, {1, 2, 3});
        test::reset_largest_allocation();
        const std::size_t before = test::allocated_bytes();
        const CutResult result = cut(std::move(object), plane);
        const double k = double(result.statistics.crossing_triangles);
        EXPECT_LE(double(test::allocated_bytes() - before), kAllocated * k) << n;
        EXPECT_LE(double(test::largest_allocation()), 1000 * k) << n;
    }
}

/// A plane across `axis` that about `wanted` triangles cross.
Plane plane_with_section(const IndexedMesh& mesh, const glm::dvec3& axis, std::uint64_t wanted)
{
    double low = 0.0, high = 2.0;
    for (int step = 0; step < 40; ++step) {
        const Plane plane = *Plane::through((low + high) / 2 * axis, axis);
        std::uint64_t crossing = 0;
        for (const Triangle& t : mesh.triangles) {
            int below = 0;
            for (const std::uint32_t v : t) below += plane.signed_distance(mesh.vertices[v].position) < 0;
            crossing += below == 1 || below == 2;
        }
        if (crossing > wanted + wanted / 10)
            low = (low + high) / 2;
        else if (crossing < wanted)
            high = (low + high) / 2;
        else
            return plane;
    }
    ADD_FAILURE() << "no such plane";
    return {};
}

/// What no counter of ours could hide: the pages that a small section of a large mesh touches, in whatever memory.
TEST(Growth, ASmallSectionOfALargeMeshTouchesLittleMemory)
{
    if (test::kAddressSanitized) GTEST_SKIP() << "the sanitizer's own memory would be counted";
    // Triangles that are neighbours across the section lie in different pages; so do their vertices, half-edges and
    // nodes. Two bytes for each triangle of the mesh would be too much.
    constexpr double kTouched = 8 * 4096;  // bytes for each crossing triangle
    constexpr std::uint64_t kCrossing = 300;
    test::use_small_pages();
    const auto bytes_touched = [](const IndexedMesh& mesh, const Plane& plane, CutStatistics& statistics) {
        auto object = std::move(make_back_end()->prepare(mesh).object);
        if (!test::forget_touched_memory()) return 0.0;
        const CutResult result = cut(std::move(object), plane);
        EXPECT_EQ(result.status, Status::done);
        statistics = result.statistics;
        return double(test::touched_memory().value_or(0));
    };
    CutStatistics statistics;
    // The program itself, and what a cut needs in any case.
    const Plane plane = *Plane::through({0.01, 0.02, 0.03}, {1, 2, 3});
    const double least = bytes_touched(test::closed_shape("cube"), plane, statistics);
    if (least == 0.0) GTEST_SKIP() << "the system does not say which pages are touched";

    const IndexedMesh mesh = test::repaired(shapes::uv_sphere(1.0f, 1600, 800));
    const Plane small = plane_with_section(mesh, glm::normalize(glm::dvec3(1, 2, 3)), kCrossing);
    // The system may look through the memory meanwhile, which counts as touching it: so a reading can be too large.
    double touched = bytes_touched(mesh, small, statistics) - least;
    for (int again = 0; again < 2 && touched > kTouched * double(statistics.crossing_triangles); ++again)
        touched = bytes_touched(mesh, small, statistics) - least;
    EXPECT_LE(touched, kTouched * double(statistics.crossing_triangles)) << touched << " bytes";
}

/// Fragments, their caps and the room that is used up are no dearer than the whole: not one cut of a chain stands out.
TEST(Growth, EveryCutOfAChainCostsWhatItsSectionCosts)
{
    constexpr std::size_t kMostRanges = 500;
    // Sections of small pieces meet more leaves for each triangle, and more of their caps.
    constexpr double kTrianglesOfPiece = 40, kBytesOfPiece = 400, kNodesOfPiece = 12;
    constexpr double kGrown = 2000;  // bytes for each crossing triangle, once reserved room is used up
    test::Random random(3);
    std::vector<std::unique_ptr<Cuttable>> pieces;
    pieces.push_back(std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(40'000, 1))).object));
    std::uint64_t grown = 0;
    for (int i = 0; i < 100; ++i) {
        const auto largest = std::max_element(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
            return a->mass_properties().volume < b->mass_properties().volume;
        });
        auto object = std::move(*largest);
        pieces.erase(largest);
        const Plane plane = *Plane::through(object->mass_properties().centre, random.direction());
        CutResult result = cut(std::move(object), plane);
        ASSERT_EQ(result.status, Status::done) << i;
        const CutStatistics& s = result.statistics;
        const double k = double(s.crossing_triangles);
        EXPECT_LE(double(s.triangles_touched), kTrianglesOfPiece * k) << i;
        EXPECT_LE(double(s.bytes_to_upload), kBytesOfPiece * k) << i;
        EXPECT_LE(double(s.nodes_visited), kNodesOfPiece * k) << i;
        EXPECT_LE(double(s.bytes_grown), kGrown * k) << i;
        grown += s.bytes_grown;
        for (auto* side : {&result.negative, &result.positive})
            for (auto& fragment : *side) {
                EXPECT_LE(fragment->draw_view().ranges.size(), kMostRanges);
                pieces.push_back(std::move(fragment));
            }
    }
    EXPECT_GT(grown, 0u) << "the chain is to use up what is reserved";
}

/// Cuts an object to pieces until memory grows: the crossing triangles of all cuts until then.
std::uint64_t crossings_until_growth(std::unique_ptr<Cuttable> object)
{
    constexpr std::uint64_t kSmallest = 500;  // triangles of what is cut
    test::Random random(2);
    std::vector<std::unique_ptr<Cuttable>> objects;
    objects.push_back(std::move(object));
    std::uint64_t crossings = 0;
    while (!objects.empty()) {
        auto next = std::move(objects.back());
        objects.pop_back();
        if (next->triangle_count() < kSmallest) continue;
        CutResult result = cut(std::move(next), *Plane::through({0, 0, 0}, random.direction()));
        crossings += result.statistics.crossing_triangles;
        if (result.statistics.bytes_grown > 0) return crossings;
        for (auto* side : {&result.negative, &result.positive})
            for (auto& fragment : *side) objects.push_back(std::move(fragment));
    }
    ADD_FAILURE() << "memory never grew";
    return crossings;
}

TEST(Growth, RoomIsThereForTheCutsThatWereNamed)
{
    constexpr std::uint64_t kSize = 20'000;
    for (const std::uint32_t cuts : {0u, 1u, 8u}) {
        PrepareOptions options;
        options.cuts_with_room = cuts;
        const ProvenMesh proven = std::move(prove(test::repaired(shapes::asteroid(kSize, 1))).mesh);
        auto object = std::move(make_back_end()->prepare(proven, options).object);
        auto copy = object->clone();
        const double named = double(std::max(cuts, 1u)) * double(crossings_of_one_cut(kSize));
        const std::uint64_t of_object = crossings_until_growth(std::move(object));
        EXPECT_GE(double(of_object), 0.5 * named) << cuts;
        EXPECT_LE(double(of_object), 3.0 * named) << cuts;
        EXPECT_EQ(crossings_until_growth(std::move(copy)), of_object) << cuts << ", a clone";
    }
}

}  // namespace
}  // namespace kerf::core::halfedge
