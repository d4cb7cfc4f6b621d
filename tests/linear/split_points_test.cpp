#include "linear/split_points.h"

#include <gtest/gtest.h>

#include "common/repair/proven_mesh.h"
#include "common/shapes/shapes.h"
#include "support/fixtures.h"

namespace kerf::core::linear {
namespace {

/// Two cubes, one above the plane z = 0 and turned over its edge, that have their points in one place in common: one
/// corner, or the two of an edge.
IndexedMesh touching_cubes(std::uint32_t points_in_common)
{
    const IndexedMesh cube = test::repaired(shapes::box({1, 1, 1}, {1, 1, 1}));
    const auto find = [&](const glm::vec3& p) {
        for (std::size_t v = 0; v < cube.vertices.size(); ++v)
            if (cube.vertices[v].position == p) return cube.points[v];
        return kNone;
    };
    IndexedMesh both = cube;
    const glm::vec3 offset(1, 1, points_in_common == 1 ? 1 : 0);
    std::vector<std::uint32_t> point_of(cube.point_count, kNone);
    for (std::uint32_t i = 0; i < points_in_common; ++i) {
        const glm::vec3 here(0.5f, 0.5f, points_in_common == 1 || i == 0 ? 0.5f : -0.5f);
        point_of[find(here - offset)] = find(here);
    }
    for (std::size_t v = 0; v < cube.vertices.size(); ++v) {
        Vertex vertex = cube.vertices[v];
        vertex.position += offset;
        both.vertices.push_back(vertex);
        std::uint32_t& point = point_of[cube.points[v]];
        if (point == kNone) point = both.point_count++;
        both.points.push_back(point);
    }
    const auto first = static_cast<std::uint32_t>(cube.vertices.size());
    for (const Triangle& t : cube.triangles) {
        both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        both.sources.push_back(0);
    }
    both.groups = {{0, static_cast<std::uint32_t>(both.triangles.size()), 0, 0, TriangleKind::surface}};
    return both;
}

TEST(SplitPoints, ACornerOfTwoCubesIsTwoPoints)
{
    IndexedMesh mesh = touching_cubes(1);
    EXPECT_NE(prove(mesh).error, "");
    const std::uint32_t before = mesh.point_count;
    split_points(mesh, *Plane::through({0, 0, 0.5}, {0, 0, 1}), 1e-6);
    EXPECT_EQ(prove(mesh).error, "");
    EXPECT_EQ(mesh.point_count, before + 1);
}

TEST(SplitPoints, AnEdgeOfTwoCubesIsTwoEdges)
{
    IndexedMesh mesh = touching_cubes(2);
    EXPECT_NE(prove(mesh).error, "");
    split_points(mesh, *Plane::through({0.5, 0.5, 0.0}, {1, -1, 0}), 1e-6);
    EXPECT_EQ(prove(mesh).error, "");
}

TEST(SplitPoints, FarFromThePlaneNothingChanges)
{
    IndexedMesh mesh = touching_cubes(1);
    split_points(mesh, *Plane::through({0, 0, -0.2}, {0, 0, 1}), 1e-6);
    EXPECT_NE(prove(mesh).error, "");
}

TEST(SplitPoints, OfAMeshThatKeepsItsPromisesNothingChanges)
{
    for (const test::NamedMesh& shape : test::closed_shapes()) {
        SCOPED_TRACE(shape.name);
        IndexedMesh mesh = shape.mesh;
        split_points(mesh, *Plane::through(mesh.bounds().centre(), {1, 2, 3}), 1e-1);
        EXPECT_EQ(mesh.points, shape.mesh.points);
        EXPECT_EQ(mesh.triangles, shape.mesh.triangles);
    }
}

TEST(SplitPoints, WhatNoTriangleUsesIsDropped)
{
    IndexedMesh mesh = test::closed_shape("cube");
    const std::size_t vertices = mesh.vertices.size();
    mesh.vertices.push_back({{9, 9, 9}, {0, 0, 1}, {}});
    mesh.points.push_back(mesh.point_count++);
    split_points(mesh, *Plane::through({0, 0, 0}, {0, 0, 1}), 1e-6);
    EXPECT_EQ(mesh.vertices.size(), vertices);
    EXPECT_EQ(prove(mesh).error, "");
}

}  // namespace
}  // namespace kerf::core::linear
