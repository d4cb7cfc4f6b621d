#include "common/repair/clean_soup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

#include "common/shapes/shapes.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kTooLarge = std::numeric_limits<float>::infinity();

bool same_vertices(const Buffer<Vertex>& a, const Buffer<Vertex>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vertex)) == 0;
}

TEST(CleanSoup, LeavesCleanNumbersAlone)
{
    TriangleSoup sphere = shapes::icosphere(1.0f, 3);
    const TriangleSoup before = sphere;
    EXPECT_EQ(clean(sphere).vertices, 0u);
    EXPECT_TRUE(same_vertices(sphere.vertices, before.vertices));
}

TEST(CleanSoup, DoesNothingTheSecondTime)
{
    TriangleSoup sphere = shapes::icosphere(1.0f, 3);
    for (std::size_t v = 0; v < sphere.vertices.size(); ++v) {
        Vertex& vertex = sphere.vertices[v];
        if (v % 5 == 1) vertex.normal *= 1.0f + 1e-7f * float(v);
        if (v % 5 == 2) vertex.normal = glm::vec3(0.0f);
        if (v % 5 == 3) vertex.normal.y = kNoNumber;
        if (v % 7 == 0) vertex.uv.x = -kTooLarge;
        if (v % 7 == 1) vertex.position.z = -0.0f;
    }
    EXPECT_GT(clean(sphere).vertices, 0u);
    const TriangleSoup once = sphere;
    EXPECT_EQ(clean(sphere).vertices, 0u);
    EXPECT_TRUE(same_vertices(sphere.vertices, once.vertices));
}

TEST(CleanSoup, GivesZerosOneSign)
{
    TriangleSoup cube = small_meshes::cube();
    cube.vertices[0].position = {-0.0f, 1.0f, -0.0f};
    clean(cube);
    EXPECT_FALSE(std::signbit(cube.vertices[0].position.x));
    EXPECT_FALSE(std::signbit(cube.vertices[0].position.z));
}

// One rule for files and programs: 1e-6 of the length.
TEST(CleanSoup, MakesNormalsUnitThatAreFartherThanTheTolerance)
{
    TriangleSoup cube = shapes::box({1, 1, 1}, {1, 1, 1});
    const glm::vec3 near(0.0f, 0.0f, 1.0f + 8e-7f), far(0.0f, 0.0f, 1.0f + 3e-6f), tiny(0.0f, 1e-40f, 0.0f);
    cube.vertices[0].normal = near;
    cube.vertices[1].normal = far;
    cube.vertices[2].normal = tiny;
    EXPECT_EQ(clean(cube).vertices, 0u);
    EXPECT_EQ(cube.vertices[0].normal, near);
    EXPECT_EQ(cube.vertices[1].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(cube.vertices[2].normal, glm::vec3(0, 1, 0));
}

TEST(CleanSoup, GivesAVertexWithoutNormalTheMeanOfItsTriangles)
{
    TriangleSoup sphere = shapes::icosphere(1.0f, 16);
    sphere.vertices[3].normal = glm::vec3(0.0f);
    sphere.vertices[5].normal.x = kNoNumber;
    const UnfitAttributes unfit = clean(sphere);
    EXPECT_EQ(unfit.normals, 1u);
    EXPECT_EQ(unfit.vertices, 1u);
    for (const std::size_t v : {3, 5})
        EXPECT_GT(glm::dot(sphere.vertices[v].normal, sphere.vertices[v].position), 0.99f);
}

TEST(CleanSoup, AsksForSmoothNormalsIfNoVertexHasOne)
{
    TriangleSoup cube = small_meshes::cube();
    for (Vertex& v : cube.vertices) v.normal = glm::vec3(0.0f);
    clean(cube);
    EXPECT_FALSE(cube.has_normals);
}

TEST(CleanSoup, CountsAVertexOnceHoweverManyOfItsNumbersAreUnfit)
{
    TriangleSoup cube = shapes::box({1, 1, 1}, {1, 1, 1});
    cube.vertices[4].normal = glm::vec3(kNoNumber);
    cube.vertices[4].uv = {kNoNumber, kTooLarge};
    cube.vertices[6].uv.y = kNoNumber;
    const UnfitAttributes unfit = clean(cube);
    EXPECT_EQ(unfit.normals, 1u);
    EXPECT_EQ(unfit.uvs, 2u);
    EXPECT_EQ(unfit.vertices, 2u);
    EXPECT_EQ(cube.vertices[4].uv, glm::vec2(0.0f));
}

TEST(CleanSoup, SetsStreamValuesThatAreNotFiniteToZero)
{
    TriangleSoup cube = small_meshes::cube();
    VertexStream& heat = cube.streams.emplace_back();
    heat.name = "heat";
    heat.width = 1;
    heat.values.assign(cube.vertices.size(), 1.0f);
    heat.values[2] = kNoNumber;
    heat.values[3] = kTooLarge;
    clean(cube);
    EXPECT_TRUE(std::isnan(heat.values[2])) << "a program may mean something by it";
    EXPECT_EQ(clean_streams(cube), 2u);
    EXPECT_EQ(heat.values[2], 0.0f);
    EXPECT_EQ(heat.values[3], 0.0f);
}

}  // namespace
}  // namespace kerf::core
