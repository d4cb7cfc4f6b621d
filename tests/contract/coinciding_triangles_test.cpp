// Closed meshes in which triangles lie on one another: whatever is done about that, they stay closed, and so do their
// halves. Judged from outside, by positions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <random>

#include "common/io/mesh_file.h"
#include "common/mesh/plane_noise.h"
#include "common/mesh/tolerances.h"
#include "common/repair/mesh_facts.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/backends.h"
#include "support/coinciding_solids.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

class CoincidingTriangles : public testing::TestWithParam<test::NamedBackend>
{
protected:
    struct Seen
    {
        std::size_t cuts = 0, kept = 0, dropped = 0;
    };

    /// What is left of a soup that is closed.
    IndexedMesh repaired(const TriangleSoup& soup)
    {
        EXPECT_EQ(measure(soup).unbalanced_edges, 0u);
        return closed(soup);
    }

    /// What is left of a soup that comes out closed.
    IndexedMesh closed(const TriangleSoup& soup)
    {
        Repaired result = repair(soup);
        EXPECT_EQ(result.error, "");
        EXPECT_EQ(referee::open_edges(result.mesh), 0u);
        EXPECT_EQ(referee::open_edges_by_position(result.mesh), 0u);
        seen_.kept += result.repairs.coinciding_triangles;
        seen_.dropped += result.repairs.duplicate_triangles;
        return *std::move(result.mesh);
    }

    /// Cuts a closed mesh, and one of the halves again.
    void expect_closed_halves(const IndexedMesh& mesh, const std::vector<test::NamedPlane>& planes)
    {
        const auto backend = GetParam().make();
        PrepareResult prepared = backend->prepare(mesh);
        ASSERT_EQ(prepared.status, Status::done) << prepared.reason;
        for (const auto& [name, plane] : planes) {
            SCOPED_TRACE(name);
            CutResult result = cut(prepared.object->clone(), plane);
            ASSERT_NE(result.status, Status::open_section);
            if (result.status == Status::missed) continue;
            ASSERT_EQ(result.status, Status::done);
            expect_parts(mesh, plane, result);
            ++seen_.cuts;

            const IndexedMesh half = result.positive.front()->to_indexed_mesh();
            const test::NamedPlane again = test::planes_for(half, 1, seen_.cuts)[seen_.cuts % 8];
            SCOPED_TRACE("again, " + again.name);
            CutOptions apart;
            apart.split_components = true;
            const CutResult quarters = cut(std::move(result.positive.front()), again.plane, apart);
            ASSERT_NE(quarters.status, Status::open_section);
            if (quarters.status == Status::done) expect_parts(half, again.plane, quarters);
        }
    }

    Seen seen_;

private:
    void expect_parts(const IndexedMesh& whole, const Plane& plane, const CutResult& result)
    {
        const double unit = plane_noise(whole.bounds().largest_coordinate()) / kNoiseInUnits;
        double sum = 0.0;
        for (const auto* side : {&result.positive, &result.negative})
            for (const auto& fragment : *side) {
                const IndexedMesh part = fragment->to_indexed_mesh();
                ASSERT_EQ(check(part), "");
                ASSERT_EQ(referee::open_edges(part), 0u);
                ASSERT_EQ(referee::open_edges_by_position(part), 0u);
                ASSERT_EQ(referee::triangles_with_equal_corners(part), 0u);
                ASSERT_LE(referee::overhang(part, plane, side == &result.positive), kNoiseInUnits * unit);
                sum += referee::volume(part);
            }
        const double volume = referee::volume(whole);
        ASSERT_NEAR(sum, volume, 1e-6 * std::abs(volume) + unit * referee::area(whole));
    }
};

/// Rounds to a lattice of so many cells along the longest side, of size 1, and moves by so many units.
void snap(TriangleSoup& soup, int cells, const glm::vec3& offset)
{
    Box box;
    for (const Vertex& v : soup.vertices) box.add(v.position);
    const glm::vec3 size = box.hi - box.lo;
    const float longest = std::max({size.x, size.y, size.z});
    for (Vertex& v : soup.vertices) v.position = glm::round((v.position - box.lo) / longest * float(cells)) + offset;
}

// The case that was found: the common base was dropped once, and one of the two solids was open.
TEST_P(CoincidingTriangles, ThatTwoSolidsHaveInCommonOpenNeither)
{
    using namespace small_meshes;
    const IndexedMesh mesh =
        repaired(soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2f, 0.2f, 1}, {0.3f, 0.3f, 2}},
                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}}));
    EXPECT_EQ(seen_.kept, 1u);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.1, 0.2, 1.0));
    std::vector<test::NamedPlane> planes = test::planes_for(mesh, 8, 1);
    planes.push_back({"as it was found", Plane{normal, glm::dot(normal, glm::dvec3(0.2, 0.2, 0.5))}});
    expect_closed_halves(mesh, planes);

    const CutResult result = cut(GetParam().make()->prepare(mesh).object, planes.back().plane);
    ASSERT_EQ(result.status, Status::done);
    EXPECT_NEAR(referee::volume(result.negative.front()->to_indexed_mesh()), 0.3243, 5e-5);
}

TEST_P(CoincidingTriangles, OfRandomSolidsLeaveClosedHalves)
{
    for (std::uint32_t seed = 0; seed < 250; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        TriangleSoup soup = small_meshes::solids_with_common_triangles(random);
        // Off the lattice, and far away, where floats have another lattice.
        if (seed % 4 == 1)
            for (Vertex& v : soup.vertices) v.position = v.position * 0.1f + glm::vec3(0.3f, 0.7f, -0.1f);
        if (seed % 4 == 2)
            for (Vertex& v : soup.vertices) v.position = v.position * 0.3f + glm::vec3(1e6f, -1e6f, 1e6f);
        const IndexedMesh mesh = repaired(soup);
        expect_closed_halves(mesh, test::planes_for(mesh, 1, seed));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(seen_.kept, 300u);
    EXPECT_GT(seen_.dropped, 300u);
    EXPECT_GT(seen_.cuts, 800u);
}

TEST_P(CoincidingTriangles, SomeOfThemTurnedOverLeaveClosedHalves)
{
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        TriangleSoup soup = small_meshes::solids_with_common_triangles(random);
        if (!small_meshes::turn_some_over(soup, random)) continue;
        const IndexedMesh mesh = closed(soup);
        expect_closed_halves(mesh, test::planes_for(mesh, 1, seed));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(seen_.kept, 100u);
    EXPECT_GT(seen_.dropped, 100u);
    EXPECT_GT(seen_.cuts, 400u);
}

// In one of them no piece has an edge of the section for itself, and what is flat went to one or another.
TEST_P(CoincidingTriangles, ComeApartAlikeForEveryBackEnd)
{
    const auto first = test::backends().front().make(), own = GetParam().make();
    CutOptions apart;
    apart.split_components = true;
    for (std::uint32_t seed = 225; seed < 265; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const IndexedMesh mesh = repaired(small_meshes::solids_with_common_triangles(random));
        for (const auto& [name, plane] : test::planes_for(mesh, 1, seed)) {
            SCOPED_TRACE(name);
            const CutResult expected = cut(first->prepare(mesh).object, plane, apart),
                            result = cut(own->prepare(mesh).object, plane, apart);
            ASSERT_EQ(result.status, expected.status);
            ASSERT_EQ(referee::canonical_pieces(result.positive), referee::canonical_pieces(expected.positive));
            ASSERT_EQ(referee::canonical_pieces(result.negative), referee::canonical_pieces(expected.negative));
        }
    }
}

TEST_P(CoincidingTriangles, OfCoarseGridsLeaveClosedHalves)
{
    for (const std::string& name : shapes::names())
        for (const int cells : {4, 8, 32}) {
            TriangleSoup soup = *shapes::make(name, 2000, 1);
            if (measure(soup).unbalanced_edges > 0) continue;
            SCOPED_TRACE(name + ", " + std::to_string(cells) + " cells");
            snap(soup, cells, cells == 8 ? glm::vec3(1e6f) : glm::vec3(0.0f));
            if (measure(soup).degenerate_triangles == soup.triangles.size()) continue;
            const IndexedMesh mesh = repaired(soup);
            expect_closed_halves(mesh, test::planes_for(mesh, 1, 1));
            if (HasFatalFailure()) return;
        }
    EXPECT_GT(seen_.kept, 10u);
    EXPECT_GT(seen_.cuts, 150u);
}

TEST_P(CoincidingTriangles, OfRealMeshesFarAwayAndOnCoarseGridsLeaveClosedHalves)
{
    const std::filesystem::path folder = KERF_SHARED_MESHES_DIR;
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared meshes are not here";
    if (GetParam().name == "baseline_scan" || GetParam().name == "baseline_two_bucket_hash")
        GTEST_SKIP() << "quadratic";
    for (const char* file : {"cheese.off", "bones.off", "knot2.off", "ADIS16480.STL", "chess_rook.obj"}) {
        const TriangleSoup original = io::read_soup(folder / file);
        for (const int cells : {0, 8, 32}) {
            SCOPED_TRACE(std::string(file) + ", " + std::to_string(cells) + " cells");
            TriangleSoup soup = original;
            if (cells > 0)
                snap(soup, cells, glm::vec3(0.0f));
            else
                for (Vertex& v : soup.vertices) v.position += 1e6f;
            if (measure(soup).degenerate_triangles == soup.triangles.size()) continue;
            const IndexedMesh mesh = repaired(soup);
            const auto planes = test::planes_for(mesh, 1, 1);
            expect_closed_halves(mesh, planes);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(seen_.kept, 100u);
}

INSTANTIATE_TEST_SUITE_P(All, CoincidingTriangles, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

}  // namespace
}  // namespace kerf::core
