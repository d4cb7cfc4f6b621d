#include <gtest/gtest.h>

#include "baseline/report_costs.h"
#include "baseline/slices.h"
#include "support/referee.h"

namespace kerf::core::baseline {
namespace {

using test::closed_shape;

TEST(Pivot, IsTheMeanOfTheVerticesAndGoesToScratch)
{
    const IndexedMesh& mesh = closed_shape("asteroid");
    const auto before = referee::bytes_of(mesh);
    Buffer<Vertex> scratch;
    const glm::vec3 pivot = rewrite_around_pivot(mesh, scratch);
    glm::dvec3 mean{0}, rest{0};
    for (const Vertex& v : mesh.vertices) mean += glm::dvec3(v.position) / double(mesh.vertices.size());
    for (const Vertex& v : scratch) rest += glm::dvec3(v.position) / double(mesh.vertices.size());
    EXPECT_NEAR(glm::length(glm::dvec3(pivot) - mean), 0, 1e-6);
    EXPECT_NEAR(glm::length(rest), 0, 1e-6);
    ASSERT_EQ(scratch.size(), mesh.vertices.size());
    EXPECT_EQ(scratch[0].normal, mesh.vertices[0].normal);
    EXPECT_EQ(referee::bytes_of(mesh), before);
}

TEST(Pivot, RewritingIsTimedAndChangesNoFragment)
{
    const Plane plane{{0, 0, 1}, 0.1};
    const auto plain = make_back_end(VertexLookup::hash), pivots = make_back_end(VertexLookup::hash, true);
    const CutResult a = cut(plain->prepare(closed_shape("asteroid")).object, plane),
                    b = cut(pivots->prepare(closed_shape("asteroid")).object, plane);
    EXPECT_EQ(report_costs(a).pivot_ms, 0.0);
    EXPECT_GT(report_costs(b).pivot_ms, 0.0);
    EXPECT_EQ(referee::bytes_of(a.positive.at(0)->to_indexed_mesh()),
              referee::bytes_of(b.positive.at(0)->to_indexed_mesh()));
}

}  // namespace
}  // namespace kerf::core::baseline
