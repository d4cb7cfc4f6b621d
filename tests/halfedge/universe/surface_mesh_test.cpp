#include "halfedge/universe/surface_mesh.h"

#include <gtest/gtest.h>

#include "support/sanitized.h"
#include "support/touched_memory.h"

namespace kerf::core::halfedge {
namespace {

constexpr SurfaceMesh::Sizes kSizes{200'000, 600'000, 400'000}, kNew{50'000, 150'000, 100'000};

/// Adds the new elements one after the other, and writes to each; returns how many pages the system had to find.
std::size_t faults_of_adding(SurfaceMesh& mesh)
{
    const std::size_t before = test::page_faults();
    EXPECT_EQ(mesh.make_room(kNew.points, kNew.edges, kNew.faces), 0u);
    mesh.resize(mesh.points() + kNew.points, mesh.edges() + kNew.edges, mesh.faces() + kNew.faces);
    for (std::size_t i = mesh.points() - kNew.points; i < mesh.points(); ++i)
        mesh.set_position(PointId(int(i)), glm::vec3(1.0f));
    return test::page_faults() - before;
}

/// The first touch of a page takes as long as a dozen crossing triangles: no cut is to pay for it.
TEST(SurfaceMesh, RoomIsTouchedBeforeItIsNeeded)
{
    if (test::kAddressSanitized) GTEST_SKIP() << "the sanitizer touches memory of its own";
    constexpr std::size_t kInAnyCase = 8;  // the stack, and pages of the program; one array alone is 50 pages and more
    // A large one would hide what is missing.
    test::use_small_pages();
    SurfaceMesh mesh;
    mesh.start({kSizes.points + 2 * kNew.points, kSizes.edges + 2 * kNew.edges, kSizes.faces + 2 * kNew.faces});
    mesh.resize(kSizes.points, kSizes.edges, kSizes.faces);
    mesh.touch_room();
    for (std::size_t i = 0; i < mesh.points(); ++i) mesh.set_position(PointId(int(i)), glm::vec3(0.0f));
    SurfaceMesh copy(mesh);
    EXPECT_LE(faults_of_adding(mesh), kInAnyCase);
    EXPECT_LE(faults_of_adding(copy), kInAnyCase) << "a copy";
    EXPECT_EQ(mesh.edges(), kSizes.edges + kNew.edges);
    EXPECT_GT(mesh.make_room(2 * kNew.points, 2 * kNew.edges, 2 * kNew.faces), 0u);
    EXPECT_LE(faults_of_adding(mesh), kInAnyCase) << "room that was made later";
}

}  // namespace
}  // namespace kerf::core::halfedge
