#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "common/io/mesh_file.h"
#include "common/repair/repair.h"
#include "maker/fruit/fruit.h"
#include "maker/fruit/soup.h"

namespace kerf::core::test {
namespace {

std::string path_of(const maker::Fruit& fruit)
{
    return KERF_DATA_DIR "/fruit/" + std::string(fruit.name) + ".glb";
}

std::string bytes_of(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

class FruitFile : public testing::TestWithParam<maker::Fruit>
{
protected:
    glm::dvec3 corner(std::size_t triangle, std::size_t k) const
    {
        return glm::dvec3(soup_.vertices[soup_.triangles[triangle][k]].position);
    }

    /// Which of the shells each triangle belongs to, by the places of its corners.
    std::vector<std::size_t> shells() const
    {
        std::map<std::array<float, 3>, std::size_t> places;
        std::vector<std::size_t> parent;
        const auto place = [&](std::uint32_t v) {
            const glm::vec3& p = soup_.vertices[v].position;
            const auto [at, is_new] = places.try_emplace({p.x, p.y, p.z}, parent.size());
            if (is_new) parent.push_back(parent.size());
            return at->second;
        };
        const auto root = [&](std::size_t i) {
            while (parent[i] != i) i = parent[i];
            return i;
        };
        for (const Triangle& t : soup_.triangles)
            for (const std::uint32_t v : t) parent[root(place(v))] = root(place(t[0]));
        std::vector<std::size_t> shell;
        for (const Triangle& t : soup_.triangles) shell.push_back(root(place(t[0])));
        return shell;
    }

    const TriangleSoup soup_ = io::read_soup(path_of(GetParam()));
};

TEST_P(FruitFile, HasBetweenTwoAndTenThousandTriangles)
{
    EXPECT_GE(soup_.triangles.size(), 2000u);
    EXPECT_LE(soup_.triangles.size(), 10000u);
}

TEST_P(FruitFile, IsClosedAndManifoldAndNeedsNoRepair)
{
    const io::LoadedMesh loaded = io::read_mesh(path_of(GetParam()));
    EXPECT_TRUE(loaded.repairs.none()) << loaded.repairs.describe();
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
    for (const Triangle& t : loaded.mesh->triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++directed[{loaded.mesh->points[t[k]], loaded.mesh->points[t[(k + 1) % 3]]}];
    for (const auto& [edge, count] : directed) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(directed.count({edge.second, edge.first}), 1u);
    }
}

TEST_P(FruitFile, IsOneShellAroundItsFleshAndOneMoreForAHollow)
{
    std::map<std::size_t, double> volumes;
    const std::vector<std::size_t> shell = shells();
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t)
        volumes[shell[t]] += glm::dot(corner(t, 0), glm::cross(corner(t, 1), corner(t, 2))) / 6.0;
    EXPECT_EQ(volumes.size(), static_cast<std::size_t>(GetParam().shells));
    std::vector<double> sorted;
    for (const auto& [root, volume] : volumes) sorted.push_back(volume);
    std::sort(sorted.rbegin(), sorted.rend());
    EXPECT_GT(sorted.front(), 0.1);
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        EXPECT_LT(sorted[i], -0.1) << "a hollow faces inwards";
        EXPECT_LT(-sorted[i], sorted.front());
    }
}

TEST_P(FruitFile, DoesNotIntersectItself)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    std::map<std::array<float, 3>, CGAL::SM_Vertex_index> points;
    std::vector<glm::vec3> first_corner;
    for (const Triangle& t : soup_.triangles) {
        std::array<CGAL::SM_Vertex_index, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& p = soup_.vertices[t[k]].position;
            const auto [at, is_new] = points.try_emplace({p.x, p.y, p.z});
            if (is_new) at->second = mesh.add_vertex({double(p.x), double(p.y), double(p.z)});
            corners[k] = at->second;
        }
        ASSERT_NE(mesh.add_face(corners[0], corners[1], corners[2]), mesh.null_face());
        first_corner.push_back(soup_.vertices[t[0]].position);
    }
    std::vector<std::pair<CGAL::SM_Face_index, CGAL::SM_Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    for (const auto& [f, g] : pairs) {
        const glm::vec3 p = first_corner[std::size_t(f)], q = first_corner[std::size_t(g)];
        ADD_FAILURE() << "triangles " << f << " and " << g << " near " << p.x << ' ' << p.y << ' ' << p.z << " and "
                      << q.x << ' ' << q.y << ' ' << q.z;
    }
}

TEST_P(FruitFile, HasUnitNormalsOnTheOutside)
{
    ASSERT_TRUE(soup_.has_normals);
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
        const glm::dvec3 outwards = glm::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0));
        for (const std::uint32_t v : soup_.triangles[t]) {
            const glm::dvec3 n(soup_.vertices[v].normal);
            EXPECT_NEAR(glm::dot(n, n), 1.0, 1e-4) << "triangle " << t;
            EXPECT_GT(glm::dot(n, outwards), 0.0)
                << "triangle " << t << " at " << soup_.vertices[v].position.x << ' ' << soup_.vertices[v].position.y
                << ' ' << soup_.vertices[v].position.z;
        }
    }
}

TEST_P(FruitFile, HasTextureCoordinatesThatSpanEachTriangle)
{
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
        std::array<glm::dvec2, 3> uv;
        for (std::size_t k = 0; k < 3; ++k) uv[k] = glm::dvec2(soup_.vertices[soup_.triangles[t][k]].uv);
        const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
        EXPECT_NE(a.x * b.y - a.y * b.x, 0.0) << "triangle " << t;
    }
}

TEST_P(FruitFile, HasNoSliver)
{
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
        const glm::dvec3 a = corner(t, 1) - corner(t, 0), b = corner(t, 2) - corner(t, 1),
                         c = corner(t, 0) - corner(t, 2);
        const double longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
        // Height over the longest side, as a share of it. Leaves end in tips.
        EXPECT_GT(glm::length(glm::cross(a, b)) / longest, 0.01) << "triangle " << t;
    }
}

TEST_P(FruitFile, NamesOnlyKnownMaterialsAndItsOwnFirst)
{
    ASSERT_FALSE(soup_.materials.empty());
    EXPECT_EQ(soup_.materials[soup_.triangle_materials.front()].name, GetParam().name);
    for (const std::uint32_t used :
         std::set<std::uint32_t>(soup_.triangle_materials.begin(), soup_.triangle_materials.end())) {
        const Material& material = soup_.materials[used];
        EXPECT_EQ(std::count_if(maker::kFruitMaterials.begin(), maker::kFruitMaterials.end(),
                                [&](const auto& known) { return known.name == material.name; }),
                  1)
            << material.name;
    }
}

TEST_P(FruitFile, IsMadeAgainByteForByte)
{
    const Repaired made = repair(maker::soup_of(GetParam().make()));
    ASSERT_EQ(made.error, "");
    const std::filesystem::path copy =
        std::filesystem::path(testing::TempDir()) / ("made_again_" + std::string(GetParam().name) + ".glb");
    io::write_mesh(copy, made.mesh);
    // Not EXPECT_EQ, which would print both files.
    EXPECT_TRUE(bytes_of(copy) == bytes_of(path_of(GetParam()))) << "run make_fruit data/fruit";
    std::filesystem::remove(copy);
}

INSTANTIATE_TEST_SUITE_P(All, FruitFile, testing::ValuesIn(maker::kFruit),
                         [](const auto& fruit) { return std::string(fruit.param.name); });

}  // namespace
}  // namespace kerf::core::test
