#include "common/mesh/indexed_mesh.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "common/repair/repair.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

/// A sound mesh with a stream, two groups and two materials.
IndexedMesh sound_mesh()
{
    IndexedMesh mesh = *repair(small_meshes::cube()).mesh;
    mesh.materials = {{"skin", glm::vec4(1.0f), {}}, {"flesh", glm::vec4(1.0f), {}}};
    const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.groups = {{0, 5, 0, 0, TriangleKind::surface}, {5, n - 5, 1, 0, TriangleKind::cap}};
    mesh.streams = {{"tint", 3, Buffer<float>(3 * mesh.vertices.size(), 0.5f)}};
    return mesh;
}

/// Something that breaks a promise, and a piece of the sentence that says so.
struct Damage
{
    const char* name;
    std::function<void(IndexedMesh&)> apply;
    const char* sentence;
};

void PrintTo(const Damage& damage, std::ostream* out)
{
    *out << damage.name;
}

class CheckedMesh : public ::testing::TestWithParam<Damage>
{
};

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinite = std::numeric_limits<float>::infinity();

const Damage kDamages[] = {
    {"coordinate_is_nan", [](IndexedMesh& m) { m.vertices[3].position.y = kNan; }, "vertex 3 has a coordinate"},
    {"coordinate_is_infinite", [](IndexedMesh& m) { m.vertices[0].position.x = -kInfinite; },
     "vertex 0 has a coordinate"},
    {"coordinate_is_minus_zero", [](IndexedMesh& m) { m.vertices[2].position.z = -0.0f; }, "vertex 2 has a coordinate"},
    {"normal_is_nan", [](IndexedMesh& m) { m.vertices[1].normal.z = kNan; }, "vertex 1 has a normal or uv"},
    {"uv_is_infinite", [](IndexedMesh& m) { m.vertices[4].uv.y = kInfinite; }, "vertex 4 has a normal or uv"},
    {"a_point_id_is_missing", [](IndexedMesh& m) { m.points.pop_back(); }, "point ids; give each vertex one"},
    {"more_points_than_vertices", [](IndexedMesh& m) { m.point_count = 1000; }, "give each point a vertex"},
    {"a_point_id_is_too_large", [](IndexedMesh& m) { m.points[5] = m.point_count; }, "vertex 5 has point id 8"},
    {"two_places_share_a_point", [](IndexedMesh& m) { m.points[5] = m.points[0]; },
     "share a point but not their position"},
    {"a_point_has_no_vertex",
     [](IndexedMesh& m) {
         for (std::uint32_t& point : m.points) point = point == 0 ? 8 : point;
         ++m.point_count;
     },
     "point 0 has no vertex"},
    {"a_stream_is_short", [](IndexedMesh& m) { m.streams[0].values.pop_back(); }, "stream 'tint'"},
    {"a_stream_is_long_by_a_vertex", [](IndexedMesh& m) { m.streams[0].values.resize(m.streams[0].values.size() + 3); },
     "stream 'tint'"},
    {"a_stream_has_no_width", [](IndexedMesh& m) { m.streams[0].width = 0; }, "stream 'tint'"},
    {"no_triangles", [](IndexedMesh& m) { m.triangles.clear(); }, "no triangles"},
    {"a_source_is_missing", [](IndexedMesh& m) { m.sources.pop_back(); }, "one source for each triangle"},
    {"a_corner_is_out_of_range",
     [](IndexedMesh& m) { m.triangles[7][1] = static_cast<std::uint32_t>(m.vertices.size()); },
     "triangle 7 refers to vertex"},
    {"two_corners_are_one", [](IndexedMesh& m) { m.triangles[4][2] = m.triangles[4][0]; },
     "triangle 4 has two corners"},
    {"a_gap_between_groups",
     [](IndexedMesh& m) {
         ++m.groups[1].first;
         --m.groups[1].count;
     },
     "do not follow one another"},
    {"groups_overlap", [](IndexedMesh& m) { --m.groups[1].first; }, "do not follow one another"},
    {"groups_end_early", [](IndexedMesh& m) { --m.groups[1].count; }, "do not cover the triangles"},
    {"groups_end_late", [](IndexedMesh& m) { ++m.groups[1].count; }, "do not cover the triangles"},
    {"group_counts_wrap_around",
     [](IndexedMesh& m) {
         m.groups[1].count = std::numeric_limits<std::uint32_t>::max();
         m.groups.push_back({4, static_cast<std::uint32_t>(m.triangles.size()) - 4, 0, 0, TriangleKind::surface});
     },
     "do not follow one another"},
    {"no_groups", [](IndexedMesh& m) { m.groups.clear(); }, "do not cover the triangles"},
    {"a_material_is_missing", [](IndexedMesh& m) { m.groups[0].material = 2; }, "refers to material 2"},
    {"a_kind_does_not_exist", [](IndexedMesh& m) { m.groups[0].kind = static_cast<TriangleKind>(7); },
     "neither surface nor cap"},
};

TEST_P(CheckedMesh, IsRefusedWithASentence)
{
    IndexedMesh mesh = sound_mesh();
    GetParam().apply(mesh);
    EXPECT_NE(check(mesh).find(GetParam().sentence), std::string::npos) << "check() says: " << check(mesh);
}

INSTANTIATE_TEST_SUITE_P(Damages, CheckedMesh, ::testing::ValuesIn(kDamages),
                         [](const auto& damage) { return std::string(damage.param.name); });

TEST(Check, FindsNothingWrongInASoundMesh)
{
    EXPECT_EQ(check(sound_mesh()), "");
}

TEST(Check, TakesWhatOnlyRidesAlong)
{
    IndexedMesh mesh = sound_mesh();
    mesh.sources[3] = 123456;
    mesh.groups[0].solid = mesh.groups[1].solid = 99;
    mesh.vertices[0].normal = {0, 0, 0};
    mesh.streams[0].values[4] = kNan;
    mesh.materials[0].name.clear();
    mesh.groups.push_back({static_cast<std::uint32_t>(mesh.triangles.size()), 0, 0, 0, TriangleKind::surface});
    EXPECT_EQ(check(mesh), "");
}

TEST(Check, RefusesAMeshOfNothing)
{
    EXPECT_NE(check(IndexedMesh{}), "");
}

TEST(AreInRange, LooksAtEveryCorner)
{
    for (std::size_t corner = 0; corner < 3; ++corner) {
        std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 0}};
        EXPECT_TRUE(are_in_range(triangles, 3));
        triangles[1][corner] = 3;
        EXPECT_FALSE(are_in_range(triangles, 3));
    }
    EXPECT_TRUE(are_in_range({}, 0));
}

TEST(Bounds, AreTheSmallestBoxAroundAllVertices)
{
    const Box box = repair(small_meshes::cube({1, 2, 3}, 2.0f)).mesh->bounds();
    EXPECT_EQ(box.lo, glm::vec3(1, 2, 3));
    EXPECT_EQ(box.hi, glm::vec3(3, 4, 5));
}

}  // namespace
}  // namespace kerf::core
