// Whatever a program hands over as a mesh is refused with a sentence or cut rightly. `./run soak-meshes` does the same
// a million times under the address sanitizer.

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <utility>

#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/backends.h"
#include "support/brief.h"
#include "support/mesh_trial.h"
#include "support/referee.h"
#include "support/wrong_meshes.h"

namespace kerf::core {
namespace {

using test::MeshChange;
using test::Verdict;

static_assert(!std::is_constructible_v<ProvenMesh, IndexedMesh>, "nobody but repair() and prove() makes one");
static_assert(!std::is_assignable_v<ProvenMesh&, IndexedMesh>);
static_assert(std::is_same_v<decltype(*std::declval<ProvenMesh&>()), const IndexedMesh&>, "it cannot be changed");
static_assert(!std::is_convertible_v<ProvenMesh, const IndexedMesh&>, "a reference would outlive the mesh");
static_assert(std::is_convertible_v<ProvenMesh&, const IndexedMesh&>);

class WrongMeshes : public testing::TestWithParam<MeshChange>
{
protected:
    WrongMeshes()
    {
        for (const test::NamedBackend& backend : test::backends()) backends_.push_back(backend.make());
    }
    std::vector<std::unique_ptr<Backend>> backends_;
};

std::string name_of_change(const testing::TestParamInfo<MeshChange>& info)
{
    std::string name;
    for (const char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, WrongMeshes, testing::ValuesIn(test::mesh_changes().begin(), test::mesh_changes().end()),
                         name_of_change);

TEST_P(WrongMeshes, AreRefusedOrCutRightlyByEveryBackEnd)
{
    constexpr std::uint64_t kMeshes = test::kBrief ? 25 : 60;
    std::uint64_t refused = 0, cuts = 0;
    for (std::uint64_t seed = 0; seed < kMeshes; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        IndexedMesh mesh = test::small_mesh(random);
        GetParam().apply(mesh, random);
        const test::MeshTrial trial = test::try_mesh(mesh, backends_, random);
        if (GetParam().verdict == Verdict::cut) {
            EXPECT_EQ(trial.refusal, "");
        }
        if (GetParam().verdict == Verdict::refused) {
            EXPECT_NE(trial.refusal, "");
        }
        refused += !trial.refusal.empty();
        cuts += trial.cuts;
    }
    EXPECT_TRUE(refused > 0 || cuts > 0);
    if (GetParam().verdict == Verdict::cut) {
        EXPECT_GT(cuts, kMeshes / 2);
    }
}

TEST(Prove, NamesTheFirstFault)
{
    const IndexedMesh cube = *repair(shapes::box({1, 1, 1}, {1, 1, 1})).mesh;
    EXPECT_EQ(prove(cube).error, "");

    IndexedMesh turned = cube;
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    EXPECT_NE(prove(turned).error.find("triangles "), std::string::npos) << prove(turned).error;
    EXPECT_NE(prove(turned).error.find("5 run along the edge"), std::string::npos) << prove(turned).error;
    EXPECT_NE(prove(turned).error.find("in the same direction"), std::string::npos) << prove(turned).error;

    IndexedMesh two = cube;
    two.vertices.push_back({{9, 9, 9}, {0, 0, 1}, {0, 0}});
    two.points.push_back(two.point_count++);
    EXPECT_EQ(prove(two).error,
              "vertex " + std::to_string(cube.vertices.size()) + " belongs to no triangle; take it out");
}

TEST(Prove, SaysWhereThereIsNothingToReferTo)
{
    IndexedMesh mesh = *repair(shapes::box({1, 1, 1}, {1, 1, 1})).mesh;
    mesh.materials.clear();
    EXPECT_EQ(prove(mesh).error, "a triangle group refers to material 0, but there is none");
    mesh.vertices.clear();
    mesh.points.clear();
    mesh.point_count = 0;
    EXPECT_EQ(prove(mesh).error,
              "triangle 0 refers to vertex " + std::to_string(mesh.triangles[0][0]) + ", but there is none");
}

TEST(Prove, QuotesNamesShortAndClean)
{
    IndexedMesh mesh = *repair(shapes::box({1, 1, 1}, {1, 1, 1})).mesh;
    mesh.streams.push_back({"a\n\x1b[2J" + std::string(1 << 20, 'x'), 1, {}});
    EXPECT_EQ(prove(mesh).error, "stream 'a??[2J" + std::string(34, 'x') +
                                     "...' does not have 1 values for each vertex, one at least; complete it or leave "
                                     "it out");
    TriangleSoup soup = shapes::box({1, 1, 1}, {1, 1, 1});
    soup.streams = mesh.streams;
    EXPECT_EQ(repair(soup).error, "stream 'a??[2J" + std::string(34, 'x') +
                                      "...' does not have 1 values per vertex; complete it or leave it out");
}

TEST(Prove, RefusesTwoConesThatShareTheirTip)
{
    IndexedMesh cones;
    const auto add = [&](const glm::vec3& p) {
        cones.vertices.push_back({p, {0, 0, 1}, {0, 0}});
        cones.points.push_back(cones.point_count++);
    };
    add({0, 0, 0});
    for (const float z : {-1.0f, 1.0f})
        for (const glm::vec2& p : {glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(-1, -1)}) add({p, z});
    cones.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}};
    cones.sources.assign(8, 0);
    cones.materials.emplace_back();
    cones.groups = {{0, 8, 0, 0, TriangleKind::surface}};
    EXPECT_EQ(check(cones), "");
    EXPECT_EQ(
        prove(cones).error,
        "the triangles around point 0 form several vertex fans; give each a point of its own, or give the triangles to "
        "repair()");
}

TEST(Prove, KeepsTheBytesOfAMesh)
{
    for (const test::NamedMesh& shape : test::closed_shapes()) {
        const Proof proof = prove(shape.mesh);
        EXPECT_EQ(proof.error, "");
        EXPECT_EQ(referee::bytes_of(proof.mesh), referee::bytes_of(shape.mesh));
    }
}

TEST(ProvenMesh, IsEmptyOnceItWasMovedAway)
{
    ProvenMesh mesh = repair(shapes::box({1, 1, 1}, {1, 1, 1})).mesh;
    const IndexedMesh taken = *std::move(mesh);
    EXPECT_EQ(taken.triangles.size(), 12u);
    // NOLINTNEXTLINE(bugprone-use-after-move): that is what is tested
    EXPECT_EQ(mesh->triangles.size() + mesh->point_count, 0u);
    EXPECT_TRUE(mesh.bounds().empty());
    for (const test::NamedBackend& backend : test::backends()) {
        const PrepareResult result = backend.make()->prepare(mesh);
        EXPECT_EQ(result.status, Status::invalid_mesh);
        EXPECT_EQ(result.reason, "the mesh has no triangles; give it one at least");
    }
}

}  // namespace
}  // namespace kerf::core
