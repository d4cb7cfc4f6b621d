#include "common/repair/smooth_normals.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

using namespace small_meshes;

TEST(SmoothNormals, AreSharpAtTheEdgesOfACube)
{
    const IndexedMesh mesh = *repair(cube()).mesh;
    EXPECT_EQ(mesh.vertices.size(), 24u);
    EXPECT_EQ(mesh.point_count, 8u);
    for (const Vertex& v : mesh.vertices) {
        const glm::vec3 n = glm::abs(v.normal);
        EXPECT_EQ(n.x + n.y + n.z, 1.0f);
        EXPECT_GT(glm::dot(v.normal, v.position - glm::vec3(0.5f)), 0.0f);
    }
}

TEST(SmoothNormals, AreRoundOnASphereWhateverItsVerticesWere)
{
    TriangleSoup mesh = shapes::icosphere(1.0f, 6), corners;
    for (const Triangle& triangle : mesh.triangles) {
        const auto n = static_cast<std::uint32_t>(corners.vertices.size());
        corners.triangles.push_back({n, n + 1, n + 2});
        for (const std::uint32_t v : triangle)
            corners.vertices.push_back({mesh.vertices[v].position, glm::vec3(0.0f), glm::vec2(0.0f)});
    }
    corners.has_normals = false;
    const Repaired result = repair(corners);
    EXPECT_EQ(result.mesh->vertices.size(), result.mesh->point_count);
    for (const Vertex& v : result.mesh->vertices) EXPECT_GT(glm::dot(v.normal, v.position), 0.999f);
}

TEST(SmoothNormals, DoNotDependOnHowFlatFacesAreDivided)
{
    // The top of a low pyramid: two of its four sides are divided in two along the slope.
    const TriangleSoup plain = soup({{0, 0, 0.5f}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
                                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
    TriangleSoup divided = plain;
    divided.vertices.push_back({{0, 1, 0}, glm::vec3(0.0f), glm::vec2(0.0f)});
    divided.triangles[0] = {0, 1, 5};
    divided.triangles.push_back({0, 5, 2});
    EXPECT_NEAR(glm::length(repair(plain).mesh->vertices[0].normal - glm::vec3(0, 0, 1)), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::length(repair(divided).mesh->vertices[0].normal - glm::vec3(0, 0, 1)), 0.0f, 1e-6f);
}

TEST(SmoothNormals, OfTrianglesWithoutAreaAreStillUnit)
{
    const Repaired flat = repair(soup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));
    for (const Vertex& v : flat.mesh->vertices) EXPECT_EQ(glm::length(v.normal), 1.0f);
}

}  // namespace
}  // namespace kerf::core
