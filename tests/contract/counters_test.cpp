// What one cut counts, to within a few per cent: the numbers that the published comparison rests on. A change that
// makes a cut look at twice as much fails here; one that is meant to changes the number beside its reason.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "baseline/baseline.h"
#include "baseline/report_costs.h"
#include "common/cutting/cut.h"
#include "common/shapes/shapes.h"
#include "support/backends.h"
#include "support/fixtures.h"

namespace kerf::core {
namespace {

using baseline::VertexLookup;

constexpr std::uint64_t kTriangles = 20'000, kSmall = 3'000;
// Shapes are made with the system's sine: another one may move a vertex across a plane, and a triangle with it.
constexpr double kShare = 0.03;

/// Counters of cuts of fresh copies by three fixed planes, added up.
CutStatistics counted(const Backend& backend, std::uint64_t triangles, std::uint64_t* comparisons = nullptr)
{
    const std::unique_ptr<Cuttable> object = backend.prepare(test::repaired(shapes::asteroid(triangles, 1))).object;
    CutStatistics sum;
    for (const glm::dvec3& normal : {glm::dvec3(1, 2, 3), glm::dvec3(-3, 1, 2), glm::dvec3(2, -3, 1)}) {
        const CutResult result = cut(object->clone(), *Plane::through({0.01, 0.02, 0.03}, normal));
        EXPECT_EQ(result.status, Status::done);
        sum.crossing_triangles += result.statistics.crossing_triangles;
        sum.nodes_visited += result.statistics.nodes_visited;
        sum.triangles_touched += result.statistics.triangles_touched;
        if (comparisons) *comparisons += baseline::report_costs(result).vertex_comparisons;
        sum.bytes_to_upload += result.statistics.bytes_to_upload;
    }
    return sum;
}

void expect_about(std::uint64_t value, double expected)
{
    EXPECT_NEAR(double(value), expected, kShare * expected);
}

TEST(Counters, OfTheHalfEdgeBackEndAreThoseThatArePublished)
{
    const test::NamedBackend& last = test::backends().back();
    if (last.name != "halfedge") GTEST_SKIP() << "the half-edge back end is not built";
    const CutStatistics sum = counted(*last.make(), kTriangles);
    expect_about(sum.crossing_triangles, 1'148);
    expect_about(sum.triangles_touched, 17'028);
    expect_about(sum.nodes_visited, 1'648);
    expect_about(sum.bytes_to_upload, 273'552);
}

TEST(Counters, OfLinearBackEndsAreInProportionToTheMesh)
{
    const CutStatistics sum = counted(*baseline::make_back_end(VertexLookup::remap), kTriangles);
    expect_about(sum.crossing_triangles, 1'148);
    expect_about(sum.triangles_touched, 60'516);
    expect_about(sum.bytes_to_upload, 1'945'456);
    EXPECT_EQ(sum.nodes_visited, 0u);
}

TEST(Counters, OfVertexComparisonsTellTheLookUpsApart)
{
    const auto comparisons = [](VertexLookup lookup) {
        std::uint64_t sum = 0;
        counted(*baseline::make_back_end(lookup), kSmall, &sum);
        return sum;
    };
    expect_about(comparisons(VertexLookup::scan), 14'062'965);
    expect_about(comparisons(VertexLookup::two_bucket_hash), 4'361'445);
    expect_about(comparisons(VertexLookup::hash), 24'751);
    EXPECT_EQ(comparisons(VertexLookup::remap), 0u);
}

}  // namespace
}  // namespace kerf::core
