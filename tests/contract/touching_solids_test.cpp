#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "common/cutting/cut.h"
#include "common/repair/repair.h"
#include "support/backends.h"
#include "support/brief.h"
#include "support/fixtures.h"
#include "support/referee.h"

// Closed meshes whose shells touch, overlap and coincide: many points lie in one place, outer loops are alike, cavities
// lie in several pieces. Pieces must not depend on the order in which a back end finds them.

namespace kerf::core {
namespace {

class TouchingSolids : public testing::TestWithParam<test::NamedBackend>
{
};

/// Tetrahedra and boxes with corners on a small lattice, some of them inside out.
IndexedMesh lattice_solids(test::Random& random)
{
    TriangleSoup soup;
    soup.has_normals = false;
    const std::uint32_t solids = 2 + random.below(4), corners = 2 + random.below(3);
    const auto corner = [&] { return glm::vec3(random.below(corners), random.below(corners), random.below(corners)); };
    for (std::uint32_t i = 0; i < solids; ++i) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        if (random.below(2) == 0) {
            for (int k = 0; k < 4; ++k) soup.vertices.push_back({corner(), {0, 0, 1}, {0, 0}});
            for (const Triangle& t : {Triangle{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})
                soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
            continue;
        }
        const glm::vec3 low = corner(), size = corner() - low;
        for (std::uint32_t k = 0; k < 8; ++k)
            soup.vertices.push_back({low + size * glm::vec3(k & 1, (k >> 1) & 1, (k >> 2) & 1), {0, 0, 1}, {0, 0}});
        for (const Triangle& t : {Triangle{0, 2, 1},
                                  {1, 2, 3},
                                  {4, 5, 6},
                                  {5, 7, 6},
                                  {0, 1, 4},
                                  {1, 5, 4},
                                  {2, 6, 3},
                                  {3, 6, 7},
                                  {0, 4, 2},
                                  {2, 4, 6},
                                  {1, 3, 5},
                                  {3, 7, 5}})
            soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    Repaired result = repair(std::move(soup));
    return *std::move(result.mesh);
}

using Pieces = std::vector<std::vector<referee::SurfaceTriangle>>;

CutResult apart(const Backend& backend, const IndexedMesh& mesh, const Plane& plane)
{
    CutOptions options;
    options.split_components = true;
    return cut(std::move(backend.prepare(mesh).object), plane, options);
}

TEST_P(TouchingSolids, ComeApartAlikeForEveryBackEndAndEitherWayOfThePlane)
{
    const auto first = test::backends().front().make(), own = GetParam().make();
    std::size_t cuts = 0, several = 0;
    // Among them one for which pieces differed; there is one in some thousand.
    for (std::uint64_t seed = 2201; seed <= (test::kBrief ? 2260u : 2400u); ++seed) {
        test::Random random(seed);
        const IndexedMesh mesh = lattice_solids(random);
        if (mesh.triangles.empty() || referee::open_edges(mesh) > 0) continue;
        for (const auto& [name, plane] : test::planes_for(mesh, 1, seed)) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + name);
            const CutResult expected = apart(*first, mesh, plane), result = apart(*own, mesh, plane);
            ASSERT_EQ(result.status, expected.status);
            if (result.status == Status::missed) continue;
            const Pieces positive = referee::canonical_pieces(result.positive),
                         negative = referee::canonical_pieces(result.negative);
            ASSERT_EQ(positive, referee::canonical_pieces(expected.positive));
            ASSERT_EQ(negative, referee::canonical_pieces(expected.negative));
            const CutResult flipped = apart(*own, mesh, plane.flipped());
            ASSERT_EQ(referee::canonical_pieces(flipped.positive), negative);
            ASSERT_EQ(referee::canonical_pieces(flipped.negative), positive);
            ++cuts;
            several += positive.size() > 1 || negative.size() > 1;
        }
    }
    EXPECT_GT(cuts, test::kBrief ? 120u : 400u);
    EXPECT_GT(several, test::kBrief ? 45u : 150u);
}

TriangleSoup tetrahedra(std::initializer_list<glm::vec3> corners, std::initializer_list<Triangle> triangles)
{
    TriangleSoup soup;
    soup.has_normals = false;
    for (const glm::vec3& p : corners) soup.vertices.push_back({p, {0, 0, 1}, {0, 0}});
    soup.triangles.assign(triangles.begin(), triangles.end());
    return soup;
}

TEST_P(TouchingSolids, ACavityThatTouchesWhatIsAroundItGoesNoOtherWay)
{
    const IndexedMesh mesh = test::repaired(tetrahedra(
        {{0, 2, 1}, {1, 0, 2}, {0, 2, 2}, {2, 1, 0}, {2, 2, 2}, {1, 1, 0}, {1, 0, 1}, {0, 1, 0}, {1, 1, 2}, {2, 2, 1}},
        {{0, 1, 2},
         {0, 2, 3},
         {0, 3, 1},
         {2, 1, 3},
         {4, 5, 6},
         {4, 6, 7},
         {4, 7, 5},
         {6, 5, 7},
         {6, 5, 8},
         {6, 8, 9},
         {6, 9, 5},
         {8, 5, 9}}));
    const Plane plane{{-0.89500272825870575, 0.21745961718119075, 0.38946300376914289}, -0.83735403794376384};
    const CutResult result = apart(*GetParam().make(), mesh, plane),
                    expected = apart(*test::backends().front().make(), mesh, plane);
    EXPECT_EQ(referee::canonical_pieces(result.positive), referee::canonical_pieces(expected.positive));
    EXPECT_EQ(referee::canonical_pieces(result.negative), referee::canonical_pieces(expected.negative));
}

INSTANTIATE_TEST_SUITE_P(All, TouchingSolids, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

}  // namespace
}  // namespace kerf::core
