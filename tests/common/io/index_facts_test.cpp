#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "common/io/mesh_file.h"
#include "common/repair/mesh_facts.h"
#include "common/repair/repair.h"
#include "support/surface_referee.h"

// measure() and repair() on real meshes, against facts that other programs found (../shared/meshes/INDEX.md).

namespace kerf::core::io {
namespace {

struct Facts
{
    std::string file;
    std::uint64_t triangles, welded, boundary_edges, boundary_loops, nonmanifold_edges, nonmanifold_points,
        misoriented_edges, shells;
    double volume;  ///< to the digits given
    int digits;
    std::uint64_t solids;  ///< not in the index: what the shells make
};

void PrintTo(const Facts& facts, std::ostream* out)
{
    *out << facts.file;
}

class IndexFacts : public ::testing::TestWithParam<Facts>
{
protected:
    void SetUp() override
    {
        const auto path = std::filesystem::path(KERF_SHARED_MESHES_DIR) / GetParam().file;
        if (!std::filesystem::exists(path)) GTEST_SKIP() << "the shared meshes are not here";
        soup_ = read_soup(path);
    }
    TriangleSoup soup_;
};

TEST_P(IndexFacts, AreMeasuredBeforeRepair)
{
    const Facts& expected = GetParam();
    const MeshFacts facts = measure(soup_);
    EXPECT_EQ(facts.triangles, expected.triangles);
    EXPECT_EQ(facts.welded_vertices, expected.welded);
    EXPECT_EQ(facts.boundary_edges, expected.boundary_edges);
    EXPECT_EQ(facts.boundary_loops, expected.boundary_loops);
    EXPECT_EQ(facts.nonmanifold_edges, expected.nonmanifold_edges);
    EXPECT_EQ(facts.nonmanifold_points, expected.nonmanifold_points);
    EXPECT_EQ(facts.misoriented_edges, expected.misoriented_edges);
    EXPECT_EQ(facts.shells, expected.shells);
    EXPECT_EQ(facts.degenerate_triangles, 0u);
    EXPECT_EQ(facts.duplicate_triangles, 0u);
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(expected.volume))) - expected.digits + 1);
    EXPECT_NEAR(facts.volume, expected.volume, 0.51 * digit);
}

TEST_P(IndexFacts, AreRepairedWithoutLosingATriangle)
{
    const Facts& expected = GetParam();
    const Repaired result = repair(soup_);
    ASSERT_EQ(result.error, "");
    EXPECT_EQ(check(result.mesh), "");
    // The referee's maps take a minute for the largest mesh in the sanitizer build: its facts must do there.
    if (expected.triangles < 200000) {
        const surface_referee::Surface surface = surface_referee::judge(result.mesh);
        EXPECT_EQ(surface.fault, "");
        if (expected.boundary_edges == 0) {
            EXPECT_EQ(surface.boundary_edges, 0u);
        }
    }
    const MeshFacts after = measure(result.mesh);
    EXPECT_TRUE(after.manifold() && after.oriented());
    EXPECT_GT(after.volume, 0.0);
    EXPECT_EQ(result.mesh->triangles.size(), expected.triangles);
    EXPECT_EQ(result.repairs.nonmanifold_edges, expected.nonmanifold_edges);
    EXPECT_EQ(result.repairs.nonmanifold_points, expected.nonmanifold_points);
    EXPECT_EQ(result.repairs.unorientable_edges, 0u);
    EXPECT_EQ(result.repairs.flipped_triangles > 0, expected.misoriented_edges > 0);
    std::uint64_t solids = 0;
    for (const TriangleGroup& group : result.mesh->groups) solids = std::max(solids, std::uint64_t{group.solid} + 1);
    EXPECT_EQ(solids, expected.solids);
}

INSTANTIATE_TEST_SUITE_P(All, IndexFacts,
                         ::testing::Values(Facts{"chess_rook.obj", 1260, 632, 0, 0, 0, 0, 0, 1, 1.83, 3, 1},
                                           Facts{"chess_knight.obj", 6624, 3314, 0, 0, 0, 0, 0, 1, 2.152, 4, 1},
                                           Facts{"suzanne_monkey.glb", 968, 505, 42, 4, 0, 2, 0, 3, 2.252, 4, 3},
                                           Facts{"milktruck_geom.glb", 3624, 1840, 8, 2, 0, 2, 0, 14, 19.25, 4, 14},
                                           Facts{"mengerSponge3.glb", 21598, 7983, 0, 0, 0, 0, 0, 1, 0.4064, 4, 1},
                                           Facts{"spot.obj", 5856, 2930, 0, 0, 0, 0, 0, 1, 0.7183, 4, 1},
                                           Facts{"bob.obj", 668, 334, 0, 0, 0, 0, 0, 1, 0.733, 3, 1},
                                           Facts{"boat.obj", 32416, 16210, 0, 0, 0, 0, 0, 1, 11.92, 4, 1},
                                           Facts{"skull.obj", 100002, 49999, 0, 0, 0, 0, 0, 1, 563.4, 4, 1},
                                           Facts{"knot2.off", 11520, 5760, 0, 0, 0, 0, 0, 2, 0.04879, 4, 2},
                                           Facts{"cheese.off", 17786, 8629, 0, 0, 0, 0, 0, 1, 0.0004412, 4, 1},
                                           Facts{"bones.off", 4204, 2154, 0, 0, 0, 0, 0, 26, 18.66, 4, 26},
                                           Facts{"mech-holes-shark.off", 10192, 5246, 304, 4, 0, 0, 0, 1, 0.4508, 4, 1},
                                           Facts{"boeing.off", 2564, 1264, 0, 0, 0, 0, 978, 1, -716.4, 4, 1},
                                           Facts{"non_manifold_face_graph.off", 21, 21, 20, 3, 1, 1, 0, 2, 1.917, 4, 3},
                                           Facts{"cubes.off", 24, 14, 0, 0, 1, 0, 0, 1, 2.0, 4, 2},
                                           Facts{"ADIS16480.STL", 7436, 3672, 0, 0, 0, 0, 0, 1, 2.819e-05, 4, 1},
                                           Facts{"mni_t1iso60_804k.ply", 804148, 402178, 0, 0, 0, 0, 0, 69, 1.877e6, 4,
                                                 1}),
                         [](const auto& test) {
                             std::string name = test.param.file;
                             for (char& c : name)
                                 if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                             return name;
                         });

}  // namespace
}  // namespace kerf::core::io
