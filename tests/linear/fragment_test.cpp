#include "linear/fragment.h"

#include <gtest/gtest.h>

#include "common/repair/proven_mesh.h"
#include "linear/fragment_object.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core::linear {
namespace {

Fragment cube()
{
    return fragment_of(prove(test::closed_shape("cube")).mesh);
}

TEST(Fragment, ASmallPieceGivesSpareRoomBack)
{
    Fragment fragment = cube();
    const auto before = referee::bytes_of(fragment.mesh);
    fragment.mesh.vertices.reserve(100 * fragment.mesh.vertices.size());
    fragment.mesh.points.reserve(100 * fragment.mesh.points.size());
    fragment.mesh.triangles.reserve(100 * fragment.mesh.triangles.size());
    fragment.mesh.sources.reserve(100 * fragment.mesh.sources.size());
    fragment.release_spare_room();
    EXPECT_EQ(fragment.mesh.vertices.capacity(), fragment.mesh.vertices.size());
    EXPECT_EQ(fragment.mesh.points.capacity(), fragment.mesh.points.size());
    EXPECT_EQ(fragment.mesh.triangles.capacity(), fragment.mesh.triangles.size());
    EXPECT_EQ(fragment.mesh.sources.capacity(), fragment.mesh.sources.size());
    EXPECT_EQ(referee::bytes_of(fragment.mesh), before);
}

TEST(Fragment, ALargePieceIsNotMoved)
{
    Fragment fragment = cube();
    fragment.mesh.vertices.reserve(2 * fragment.mesh.vertices.size());
    const Vertex* const place = fragment.mesh.vertices.data();
    fragment.release_spare_room();
    EXPECT_EQ(fragment.mesh.vertices.data(), place);
}

TEST(Fragment, BoundsAreThoseOfItsVertices)
{
    const Fragment fragment = cube();
    EXPECT_EQ(fragment.bounds.lo, glm::vec3(-0.5f));
    EXPECT_EQ(fragment.bounds.hi, glm::vec3(0.5f));
}

}  // namespace
}  // namespace kerf::core::linear
