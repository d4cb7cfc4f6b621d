#include "baseline/vertex_lookup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "baseline/slices.h"
#include "common/repair/repair.h"
#include "common/shapes/hard_sections.h"
#include "support/referee.h"

namespace kerf::core::baseline {
namespace {

using test::closed_shape;
using test::closed_shapes;

/// Every triangle, caps included, by what its corners are and not by their indices: sorted.
std::vector<std::vector<std::uint32_t>> canonical(const IndexedMesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> result;
    for (const TriangleGroup& group : mesh.groups)
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            std::array<std::vector<std::uint32_t>, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t v = mesh.triangles[t][i];
                corners[i].resize(sizeof(Vertex) / sizeof(std::uint32_t));
                std::memcpy(corners[i].data(), &mesh.vertices[v], sizeof(Vertex));
                for (const VertexStream& stream : mesh.streams)
                    for (std::uint32_t w = 0; w < stream.width; ++w) {
                        std::uint32_t bits;
                        std::memcpy(&bits, &stream.values[std::size_t(v) * stream.width + w], sizeof bits);
                        corners[i].push_back(bits);
                    }
            }
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            std::vector<std::uint32_t> triangle{group.material, group.solid, std::uint32_t(group.kind),
                                                mesh.sources[t]};
            for (const auto& corner : corners) triangle.insert(triangle.end(), corner.begin(), corner.end());
            result.push_back(std::move(triangle));
        }
    std::sort(result.begin(), result.end());
    return result;
}

/// Calls visit(hash's fragments, lookup's fragments) for each side of many cuts.
template <class Visit>
void for_each_cut(VertexLookup lookup, Visit&& visit)
{
    for (const bool in_pieces : {false, true}) {
        CutOptions options;
        options.split_components = in_pieces;
        for (const test::NamedMesh& shape : closed_shapes()) {
            const Fragment whole = fragment_of(shape.mesh);
            for (const test::NamedPlane& plane : test::planes_for(shape.mesh, 2, 53)) {
                SCOPED_TRACE(shape.name + ", plane " + plane.name);
                const Slices hash = slice(whole, plane.plane, options, VertexLookup::hash),
                             other = slice(whole, plane.plane, options, lookup);
                ASSERT_EQ(hash.status, other.status);
                ASSERT_EQ(hash.positive.size(), other.positive.size());
                ASSERT_EQ(hash.negative.size(), other.negative.size());
                for (std::size_t i = 0; i < hash.positive.size(); ++i) visit(hash.positive[i], other.positive[i]);
                for (std::size_t i = 0; i < hash.negative.size(); ++i) visit(hash.negative[i], other.negative[i]);
            }
        }
    }
}

TEST(VertexLookup, ScanAndTwoBucketsGiveTheBytesOfHash)
{
    for (const VertexLookup lookup : {VertexLookup::scan, VertexLookup::two_bucket_hash})
        for_each_cut(lookup, [](const Fragment& hash, const Fragment& other) {
            EXPECT_EQ(referee::bytes_of(hash.mesh), referee::bytes_of(other.mesh));
            EXPECT_EQ(hash.fan_centres, other.fan_centres);
        });
}

TEST(VertexLookup, RemapGivesTheSameFragmentsInAnotherVertexOrder)
{
    for_each_cut(VertexLookup::remap, [](const Fragment& hash, const Fragment& remap) {
        EXPECT_EQ(canonical(hash.mesh), canonical(remap.mesh));
        EXPECT_EQ(hash.mesh.point_count, remap.mesh.point_count);
        EXPECT_EQ(hash.mesh.triangles.size(), remap.mesh.triangles.size());
        EXPECT_EQ(hash.fan_centres.size(), remap.fan_centres.size());
    });
}

TEST(VertexLookup, AVertexOnThePlaneGoesToBothSidesAndKeepsItsAttributes)
{
    // The grid cube has a ring of vertices, with seams at its edges, in z = 0.
    const IndexedMesh& mesh = closed_shape("grid_cube");
    const auto count_on_plane = [](const IndexedMesh& m) {
        return std::count_if(m.vertices.begin(), m.vertices.end(),
                             [](const Vertex& v) { return v.position.z == 0.0f && std::abs(v.normal.z) < 0.5f; });
    };
    for (const VertexLookup lookup : kAllLookups) {
        const Slices slices = slice(fragment_of(mesh), {{0, 0, 1}, 0.0}, {}, lookup);
        EXPECT_EQ(slices.statistics.crossing_triangles, 0u);
        EXPECT_EQ(count_on_plane(slices.positive.at(0).mesh), count_on_plane(mesh)) << name_of(lookup);
        EXPECT_EQ(count_on_plane(slices.negative.at(0).mesh), count_on_plane(mesh)) << name_of(lookup);
        EXPECT_NEAR(slices.section_area, 4.0, 1e-12);
    }
}

TEST(VertexLookup, ASpikeWhoseCutPointsFallTogetherLeavesNoVertexBehind)
{
    // Nothing of the spike is left above the plane; its tip must go too, though no cut point fell on a corner.
    const IndexedMesh mesh =
        test::repaired(joined(prism({{4, 4}, {5, 4}, {5, 5}, {4, 5}}, {{0, 1, 2}, {0, 2, 3}}), spike()));
    for (const VertexLookup lookup : kAllLookups) {
        SCOPED_TRACE(name_of(lookup));
        const Slices slices = slice(fragment_of(mesh), {{0, 0, 1}, 0.0}, {}, lookup);
        ASSERT_EQ(slices.status, Status::done);
        for (const Fragment& side : {slices.positive.at(0), slices.negative.at(0)}) {
            std::vector<bool> is_used(side.mesh.vertices.size(), false);
            for (const Triangle& t : side.mesh.triangles)
                for (const std::uint32_t v : t) is_used[v] = true;
            EXPECT_EQ(std::count(is_used.begin(), is_used.end(), false), 0);
            EXPECT_EQ(referee::open_edges(side.mesh), 0u);
        }
    }
}

/// Two vertices that differ in nothing but what `change` does to the second one.
template <class Change>
IndexedMesh alike_but_for(Change&& change)
{
    IndexedMesh mesh;
    mesh.vertices.assign(2, {{1, 2, 3}, {0, 0, 1}, {0, 0}});
    mesh.points.assign(2, 0);
    mesh.streams.push_back({"heat", 1, {}});
    mesh.streams.front().values.assign(2, 0.5f);
    change(mesh);
    return mesh;
}

TEST(Hashes, TheReportsHasTwoValues)
{
    const auto report = [](const glm::vec3& p) {
        return TwoValuedHash::of(alike_but_for([&](IndexedMesh& mesh) { mesh.vertices[1].position = p; }), 1);
    };
    EXPECT_EQ(report({3, 5, 7}), report({1000, 2, 0}));
    EXPECT_NE(report({0, 0, 0}), report({1, 0, 0}));
}

TEST(Hashes, TheProperOneTellsApartAllThatMakesVerticesDiffer)
{
    const auto same = [](auto change) {
        const IndexedMesh mesh = alike_but_for(change);
        EXPECT_EQ(ProperHash::of(mesh, 0) == ProperHash::of(mesh, 1), same_vertex(mesh, 0, 1));
        return same_vertex(mesh, 0, 1);
    };
    EXPECT_TRUE(same([](IndexedMesh&) {}));
    EXPECT_FALSE(same([](IndexedMesh& mesh) { mesh.vertices[1].position = {3, 2, 1}; }));
    EXPECT_FALSE(same([](IndexedMesh& mesh) { mesh.vertices[1].normal = {0, 1, 0}; }));
    EXPECT_FALSE(same([](IndexedMesh& mesh) { mesh.vertices[1].uv.y = -0.0f; }));
    EXPECT_FALSE(same([](IndexedMesh& mesh) { mesh.points[1] = 1; }));
    EXPECT_FALSE(same([](IndexedMesh& mesh) { mesh.streams.front().values[1] = 0.25f; }));
}

TEST(VertexLookup, ComparesNoMoreWhereAllCutPointsLieInOnePlace)
{
    // Sixteen times the solids: as many times the comparisons, where chains by position would take 256 times as many.
    constexpr std::uint32_t kFew = 150, kGrowth = 16;
    constexpr double kMostGrowth = 20.0;
    for (const std::string name : {"wedges", "stack"}) {
        SCOPED_TRACE(name);
        const auto comparisons = [&](std::uint32_t n) {
            const shapes::HardSection section = *shapes::hard_section(name, n);
            const Fragment whole = fragment_of(*repair(section.soup).mesh);
            const Slices slices = slice(whole, section.plane, {}, VertexLookup::hash);
            EXPECT_GE(slices.statistics.crossing_triangles, 3 * n);
            return double(slices.vertex_comparisons);
        };
        EXPECT_GT(comparisons(kFew), kFew);
        EXPECT_LE(comparisons(kGrowth * kFew), kMostGrowth * comparisons(kFew));
    }
}

}  // namespace
}  // namespace kerf::core::baseline
