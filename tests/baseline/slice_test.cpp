#include "baseline/slice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "baseline/slices.h"
#include "common/shapes/shapes.h"
#include "support/referee.h"

namespace kerf::core::baseline {
namespace {

using test::closed_shape;
using test::closed_shapes;

/// Cuts `mesh` by many planes with hash and remap; visit(slices, plane) sees those that hit.
template <class Visit>
void for_each_cut(const IndexedMesh& mesh, Visit&& visit)
{
    const Fragment whole = fragment_of(mesh);
    for (const test::NamedPlane& plane : test::planes_for(mesh, 3, 61))
        for (const VertexLookup lookup : {VertexLookup::hash, VertexLookup::remap}) {
            SCOPED_TRACE(plane.name + ", " + std::string(name_of(lookup)));
            const Slices slices = slice(whole, plane.plane, {}, lookup);
            if (slices.status == Status::done) visit(slices, plane.plane);
        }
}

TEST(Slice, StreamsOfAnyWidthAreCarriedAndInterpolated)
{
    // A linear function of the position stays one, on surface and cap alike.
    for (const std::uint32_t width : {1u, 3u, 4u, 7u}) {
        SCOPED_TRACE(width);
        const auto value = [](const glm::vec3& p, std::uint32_t w) { return p.x + float(w) * p.y - 2.0f * p.z + 0.5f; };
        TriangleSoup soup = shapes::torus(1.0f, 0.4f, 12, 8);
        VertexStream stream{"linear", width, {}};
        for (const Vertex& v : soup.vertices)
            for (std::uint32_t w = 0; w < width; ++w) stream.values.push_back(value(v.position, w));
        soup.streams = {std::move(stream)};
        const IndexedMesh mesh = test::repaired(std::move(soup));
        for_each_cut(mesh, [&](const Slices& slices, const Plane&) {
            for (const Fragment& side : {slices.positive.at(0), slices.negative.at(0)}) {
                ASSERT_EQ(side.mesh.streams.size(), 1u);
                const VertexStream& carried = side.mesh.streams[0];
                EXPECT_EQ(carried.name, "linear");
                ASSERT_EQ(carried.values.size(), side.mesh.vertices.size() * width);
                // The fan's centre has the mean of its own loop, but lies at the mean of all.
                const bool one_loop = side.fan_centres.size() == 1;
                for (std::size_t v = 0; v < side.mesh.vertices.size(); ++v) {
                    const auto& centres = side.fan_centres;
                    if (!one_loop && std::find(centres.begin(), centres.end(), v) != centres.end()) continue;
                    for (std::uint32_t w = 0; w < width; ++w)
                        EXPECT_NEAR(carried.values[v * width + w], value(side.mesh.vertices[v].position, w), 1e-5);
                }
            }
        });
    }
}

TEST(Slice, TrianglesKeepTheMaterialAndTheAreaOfTheirSource)
{
    // Five materials at random: many short groups.
    TriangleSoup soup = shapes::uv_sphere(1.0f, 16, 10);
    test::Random random(9);
    soup.materials.resize(5);
    for (std::size_t i = 0; i < 5; ++i) soup.materials[i].name = "material " + std::to_string(i);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) soup.triangle_materials.push_back(random.below(5));
    const std::vector<std::uint32_t> material_of_source = soup.triangle_materials;
    const IndexedMesh mesh = test::repaired(std::move(soup));
    const auto area_by_source = [](const std::vector<const IndexedMesh*>& meshes) {
        std::map<std::uint32_t, double> areas;
        for (const IndexedMesh* m : meshes)
            for (std::size_t t = 0; t < m->triangles.size(); ++t) {
                if (m->sources[t] == kNoSource) continue;
                const glm::dvec3 a(m->vertices[m->triangles[t][0]].position),
                    b(m->vertices[m->triangles[t][1]].position), c(m->vertices[m->triangles[t][2]].position);
                areas[m->sources[t]] += glm::length(glm::cross(b - a, c - a)) / 2;
            }
        return areas;
    };
    const std::map<std::uint32_t, double> expected = area_by_source({&mesh});
    for_each_cut(mesh, [&](const Slices& slices, const Plane&) {
        const IndexedMesh &above = slices.positive.at(0).mesh, &below = slices.negative.at(0).mesh;
        for (const IndexedMesh* side : {&above, &below})
            for (const TriangleGroup& group : side->groups)
                for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
                    if (group.kind == TriangleKind::cap)
                        EXPECT_EQ(side->materials[group.material].name, "cap");
                    else
                        EXPECT_EQ(group.material, material_of_source[side->sources[t]]);
                    EXPECT_EQ(side->sources[t] == kNoSource, group.kind == TriangleKind::cap);
                }
        const std::map<std::uint32_t, double> found = area_by_source({&above, &below});
        ASSERT_EQ(found.size(), expected.size());
        for (const auto& [source, area] : expected) EXPECT_NEAR(found.at(source), area, 1e-6);
    });
}

TEST(Slice, GroupsOfOneKindStayTogetherHoweverOftenTheyAreCut)
{
    Fragment fragment = fragment_of(closed_shape("torus"));
    ASSERT_EQ(fragment.mesh.materials.size(), 2u);
    test::Random random(4);
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 centre = fragment.bounds.centre();
        Slices slices = slice(fragment, *Plane::through(centre, random.direction()), {}, VertexLookup::remap);
        if (slices.status != Status::done) continue;
        fragment = std::move(slices.positive.at(0));
        // Untouched and divided triangles of two materials, untouched, divided and new caps.
        EXPECT_LE(fragment.mesh.groups.size(), 7u);
        EXPECT_EQ(fragment.mesh.materials.size(), 3u) << "one cap material, however many cuts";
    }
}

TEST(Slice, TheCapMaterialCanBeChosen)
{
    CutOptions options;
    options.cap_material = 1;
    const Slices slices = slice(fragment_of(closed_shape("torus")), {{0, 0, 1}, 0.1}, options, VertexLookup::hash);
    const IndexedMesh& mesh = slices.positive.at(0).mesh;
    EXPECT_EQ(mesh.materials.size(), 2u);
    EXPECT_EQ(mesh.groups.back().kind, TriangleKind::cap);
    EXPECT_EQ(mesh.groups.back().material, 1u);
}

TEST(Slice, FragmentsKnowTheBoxAroundTheirVertices)
{
    for (const test::NamedMesh& shape : closed_shapes()) {
        SCOPED_TRACE(shape.name);
        const Fragment whole = fragment_of(shape.mesh);
        for (const test::NamedPlane& plane : test::planes_for(shape.mesh, 2, 3))
            for (const VertexLookup lookup : kAllLookups)
                for (const bool in_pieces : {false, true}) {
                    CutOptions options;
                    options.split_components = in_pieces;
                    const Slices slices = slice(whole, plane.plane, options, lookup);
                    for (const auto* side : {&slices.positive, &slices.negative})
                        for (const Fragment& fragment : *side) {
                            const Box box = fragment.mesh.bounds();
                            EXPECT_EQ(fragment.bounds.lo, box.lo) << plane.name << ", " << name_of(lookup);
                            EXPECT_EQ(fragment.bounds.hi, box.hi) << plane.name << ", " << name_of(lookup);
                        }
                }
    }
}

TEST(Slice, BytesToUploadAreThoseOfTheFragments)
{
    for (const test::NamedMesh& shape : closed_shapes()) {
        SCOPED_TRACE(shape.name);
        for_each_cut(shape.mesh, [](const Slices& slices, const Plane&) {
            std::uint64_t bytes = 0;
            for (const auto* side : {&slices.positive, &slices.negative})
                for (const Fragment& fragment : *side)
                    bytes += fragment.mesh.vertices.size() * 32 + fragment.mesh.triangles.size() * 12;
            EXPECT_EQ(slices.statistics.bytes_to_upload, bytes);
        });
    }
}

TEST(Slice, CrossingTrianglesAreThoseWithVerticesStrictlyOnBothSides)
{
    for (const test::NamedMesh& shape : closed_shapes()) {
        SCOPED_TRACE(shape.name);
        for_each_cut(shape.mesh, [&](const Slices& slices, const Plane& plane) {
            std::uint64_t count = 0;
            for (const Triangle& t : shape.mesh.triangles) {
                bool above = false, below = false;
                for (const std::uint32_t v : t) {
                    const glm::dvec3 p(shape.mesh.vertices[v].position);
                    const double d = plane.normal.x * p.x + plane.normal.y * p.y + plane.normal.z * p.z - plane.offset;
                    above |= d > 0;
                    below |= d < 0;
                }
                count += above && below;
            }
            EXPECT_EQ(slices.statistics.crossing_triangles, count);
        });
    }
}

TEST(Slice, ALinearCutterTouchesEveryTriangleAndTheBoundsSpareItAMiss)
{
    const IndexedMesh& mesh = closed_shape("icosphere");
    const Fragment whole = fragment_of(mesh);
    for (const VertexLookup lookup : kAllLookups) {
        const Slices hit = slice(whole, {{0, 0, 1}, 0.1}, {}, lookup), miss = slice(whole, {{0, 0, 1}, 2}, {}, lookup);
        EXPECT_EQ(hit.statistics.triangles_touched, mesh.triangles.size());
        EXPECT_EQ(hit.statistics.triangles, mesh.triangles.size());
        EXPECT_EQ(miss.status, Status::missed);
        EXPECT_EQ(miss.statistics.triangles_touched, 0u);
        EXPECT_EQ(miss.statistics.triangles, mesh.triangles.size());
    }
}

TEST(Slice, ASideOfWhichNothingIsLeftIsAMiss)
{
    // The spike reaches a whole unit above the plane, but all its pieces there collapse into one point.
    const Fragment whole = fragment_of(test::repaired(spike()));
    for (const VertexLookup lookup : kAllLookups) {
        const Slices slices = slice(whole, {{0, 0, 1}, 0.0}, {}, lookup);
        EXPECT_EQ(slices.status, Status::missed) << name_of(lookup);
        EXPECT_TRUE(slices.positive.empty() && slices.negative.empty());
    }
}

TEST(Slice, FanCentresAreNotTakenForSurface)
{
    // A centre is a rounded mean and may stick out; it must not make a second cut by the same plane hit.
    const Plane plane = *Plane::through({0.01, 0.02, 0.03}, {1, 2, 3});
    const Slices slices = slice(fragment_of(closed_shape("asteroid")), plane, {}, VertexLookup::remap);
    Fragment side = slices.negative.at(0);
    for (const std::uint32_t v : side.fan_centres) side.mesh.vertices[v].position += glm::vec3(1e-3f, 2e-3f, 3e-3f);
    EXPECT_EQ(slice(side, plane, {}, VertexLookup::remap).status, Status::missed);
}

}  // namespace
}  // namespace kerf::core::baseline
