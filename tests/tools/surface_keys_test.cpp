#include "tools/surface_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>
#include <random>
#include <utility>

#include "common/shapes/shapes.h"
#include "support/public_mesh.h"

// What decides whether two back ends agree must see every difference and nothing else.

namespace kerf::tools {
namespace {

/// A torus with a colour stream, two materials and two groups.
FlatMesh sample()
{
    core::TriangleSoup soup = core::shapes::torus(1.0f, 0.4f, 12, 8);
    core::VertexStream colour{"colour", 3, {}};
    for (const core::Vertex& v : soup.vertices)
        for (int i = 0; i < 3; ++i) colour.values.push_back(v.position[i] * 0.25f);
    soup.streams.push_back(std::move(colour));
    soup.materials = {{"lower", glm::vec4(1.0f), {}}, {"upper", glm::vec4(1.0f), {}}};
    for (const Triangle& t : soup.triangles)
        soup.triangle_materials.push_back(soup.vertices[t[0]].position.z > 0.0f ? 1u : 0u);
    return flat(test::mesh_of(soup));
}

SurfaceDifference difference(const FlatMesh& a, const FlatMesh& b)
{
    return compare_surfaces(SurfaceKeys(a), SurfaceKeys(b));
}

void change_last_bit(float& value)
{
    value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) ^ 1u);
}

/// The same surface with triangles shuffled within their groups, corners turned, and vertices numbered anew.
FlatMesh renumbered(const FlatMesh& mesh)
{
    std::mt19937 random(7);
    FlatMesh other = mesh;
    std::vector<std::uint32_t> to(mesh.vertices.size());
    std::iota(to.begin(), to.end(), 0u);
    std::shuffle(to.begin(), to.end(), random);
    for (std::size_t v = 0; v < to.size(); ++v) {
        other.vertices[to[v]] = mesh.vertices[v];
        other.points[to[v]] = mesh.points[v];
        std::copy_n(&mesh.streams[0].values[3 * v], 3, &other.streams[0].values[3 * std::size_t{to[v]}]);
    }
    for (const TriangleGroup& group : mesh.groups) {
        std::vector<std::uint32_t> from(group.count);
        std::iota(from.begin(), from.end(), group.first);
        std::shuffle(from.begin(), from.end(), random);
        for (std::uint32_t i = 0; i < group.count; ++i) {
            const std::size_t turn = random() % 3;
            for (std::size_t k = 0; k < 3; ++k)
                other.triangles[group.first + i][k] = to[mesh.triangles[from[i]][(k + turn) % 3]];
            other.sources[group.first + i] = mesh.sources[from[i]];
        }
    }
    return other;
}

TEST(SurfaceKeys, AreTheSameHoweverAMeshIsNumbered)
{
    const FlatMesh mesh = sample(), other = renumbered(mesh);
    ASSERT_GT(mesh.groups.size(), 1u);
    EXPECT_TRUE(difference(mesh, other).none());
    const SurfaceKeys a(mesh), b(other);
    ASSERT_EQ(a.sorted().size(), b.sorted().size());
    for (std::size_t i = 0; i < a.sorted().size(); ++i)
        for (std::uint32_t k = 0; k < 3; ++k) EXPECT_EQ(a.position(a.sorted()[i], k), b.position(b.sorted()[i], k));
}

TEST(SurfaceKeys, OneBitOfOneAttributeOfOneCornerMakesSurfacesDiffer)
{
    const FlatMesh mesh = sample();
    const std::size_t victim = mesh.triangles[mesh.triangles.size() / 2][1];
    const auto users =
        static_cast<std::uint64_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
            return std::find(t.begin(), t.end(), victim) != t.end();
        }));
    const std::vector<std::pair<const char*, std::function<float&(FlatMesh&)>>> attributes{
        {"position.x", [&](FlatMesh& m) -> float& { return m.vertices[victim].position.x; }},
        {"position.y", [&](FlatMesh& m) -> float& { return m.vertices[victim].position.y; }},
        {"position.z", [&](FlatMesh& m) -> float& { return m.vertices[victim].position.z; }},
        {"normal.x", [&](FlatMesh& m) -> float& { return m.vertices[victim].normal.x; }},
        {"normal.y", [&](FlatMesh& m) -> float& { return m.vertices[victim].normal.y; }},
        {"normal.z", [&](FlatMesh& m) -> float& { return m.vertices[victim].normal.z; }},
        {"uv.x", [&](FlatMesh& m) -> float& { return m.vertices[victim].uv.x; }},
        {"uv.y", [&](FlatMesh& m) -> float& { return m.vertices[victim].uv.y; }},
        {"stream", [&](FlatMesh& m) -> float& { return m.streams[0].values[3 * victim + 2]; }},
    };
    for (const auto& [name, attribute] : attributes) {
        FlatMesh other = renumbered(mesh);
        EXPECT_TRUE(difference(mesh, other).none());
        other = mesh;
        change_last_bit(attribute(other));
        const SurfaceDifference found = difference(mesh, renumbered(other));
        EXPECT_EQ(found.only_first, users) << name;
        EXPECT_EQ(found.only_second, users) << name;
    }
}

TEST(SurfaceKeys, PlusAndMinusZeroDiffer)
{
    FlatMesh mesh = sample(), other = mesh;
    mesh.vertices[0].uv.x = 0.0f;
    other.vertices[0].uv.x = -0.0f;
    EXPECT_FALSE(difference(mesh, other).none());
}

TEST(SurfaceKeys, SourceMaterialSolidAndOrientationCount)
{
    const FlatMesh mesh = sample();
    FlatMesh other = mesh;
    other.sources[5] += 1;
    EXPECT_EQ(difference(mesh, other).only_first, 1u);
    other = mesh;
    other.groups[0].material = 1 - other.groups[0].material;
    EXPECT_EQ(difference(mesh, other).only_first, mesh.groups[0].count);
    other = mesh;
    other.groups[0].solid += 1;
    EXPECT_EQ(difference(mesh, other).only_first, mesh.groups[0].count);
    other = mesh;
    std::swap(other.triangles[5][0], other.triangles[5][1]);
    EXPECT_EQ(difference(mesh, other).only_first, 1u);
    other = mesh;
    other.materials[1].name = "upside";
    EXPECT_TRUE(difference(mesh, other).other_layout);
    other = mesh;
    other.streams[0].name = "color";
    EXPECT_TRUE(difference(mesh, other).other_layout);
}

TEST(SurfaceKeys, TrianglesAreCountedAndNotOnlyFound)
{
    const FlatMesh mesh = sample();
    FlatMesh more = mesh;
    more.triangles.push_back(mesh.triangles.back());
    more.sources.push_back(mesh.sources.back());
    more.groups.back().count += 1;
    EXPECT_EQ(difference(mesh, more).only_first, 0u);
    EXPECT_EQ(difference(mesh, more).only_second, 1u);
    EXPECT_EQ(difference(more, mesh).only_first, 1u);
    EXPECT_TRUE(difference(more, more).none());
}

TEST(SurfaceKeys, CapsDoNotCount)
{
    FlatMesh mesh = sample();
    const std::uint32_t all = static_cast<std::uint32_t>(mesh.triangles.size());
    FlatMesh other = mesh;
    other.groups.back().kind = kerf::TriangleKind::cap;
    EXPECT_EQ(SurfaceKeys(other).sorted().size(), all - mesh.groups.back().count);
    mesh.groups.back().kind = kerf::TriangleKind::cap;
    change_last_bit(other.vertices[other.triangles.back()[0]].uv.x);
    EXPECT_EQ(difference(mesh, other).only_first,
              static_cast<std::uint64_t>(std::count_if(
                  mesh.triangles.begin(), mesh.triangles.end() - mesh.groups.back().count, [&](const Triangle& t) {
                      return std::find(t.begin(), t.end(), mesh.triangles.back()[0]) != t.end();
                  })));
}

}  // namespace
}  // namespace kerf::tools
