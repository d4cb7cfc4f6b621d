#include "common/mesh/mass_properties.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/mesh/mass_moments.h"
#include "common/shapes/shapes.h"
#include "common/support/processor.h"

namespace kerf::core {
namespace {

// Generated shapes are whole already: only the fields that mass_properties() reads are filled in.
IndexedMesh mesh_of(const TriangleSoup& soup)
{
    IndexedMesh mesh;
    mesh.vertices = soup.vertices;
    mesh.triangles = soup.triangles;
    return mesh;
}

TriangleSoup moved(TriangleSoup soup, const glm::vec3& by)
{
    for (Vertex& v : soup.vertices) v.position += by;
    return soup;
}

glm::dmat3 box_inertia(const glm::dvec3& size)
{
    const double mass = size.x * size.y * size.z;
    const glm::dvec3 q = size * size * (mass / 12.0);
    return glm::dmat3(q.y + q.z, 0, 0, 0, q.z + q.x, 0, 0, 0, q.x + q.y);
}

void expect_near(const glm::dmat3& a, const glm::dmat3& b, double tolerance)
{
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(a[i][j], b[i][j], tolerance) << i << ", " << j;
    }
}

TEST(MassProperties, OfABoxAreExact)
{
    const glm::dvec3 size{1.0, 2.0, 4.0};
    const MassProperties mass = mass_properties(mesh_of(shapes::box(size, {3, 4, 5})));
    EXPECT_NEAR(mass.volume, 8.0, 1e-6);
    EXPECT_NEAR(glm::length(mass.centre), 0.0, 1e-7);
    expect_near(mass.inertia, box_inertia(size), 1e-5);
    // Corners in halves and quarters are exact in float: then so is everything.
    const MassProperties exact = mass_properties(mesh_of(shapes::box(size, {1, 1, 1})));
    EXPECT_NEAR(exact.volume, 8.0, 1e-14);
    expect_near(exact.inertia, box_inertia(size), 1e-13);
}

TEST(MassProperties, AreAboutTheCentreOfMassWhereverTheBoxIs)
{
    const glm::dvec3 size{1.0, 2.0, 4.0};
    for (const glm::vec3 where : {glm::vec3{0.5f, 1.0f, 2.0f}, {3, 0, 0}, {10, -20, 30}, {1e4f, 1e4f, -1e4f}}) {
        const MassProperties mass = mass_properties(mesh_of(moved(shapes::box(size, {1, 1, 1}), where)));
        EXPECT_NEAR(mass.volume, 8.0, 1e-12);
        EXPECT_NEAR(glm::length(mass.centre - glm::dvec3(where)), 0.0, 1e-11);
        expect_near(mass.inertia, box_inertia(size), 1e-11);
    }
}

TEST(MassProperties, OffDiagonalsFollowTheAxes)
{
    // Two cubes of side 1 at +-(2, 2, 0), written as one solid of two shells: products of inertia by parallel axes.
    TriangleSoup soup = moved(shapes::box(glm::vec3(1.0f), glm::uvec3(1)), {2, 2, 0});
    const TriangleSoup other = moved(shapes::box(glm::vec3(1.0f), glm::uvec3(1)), {-2, -2, 0});
    const auto base = std::uint32_t(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles) soup.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    const MassProperties mass = mass_properties(mesh_of(soup));
    const double own = 2.0 / 6.0;
    glm::dmat3 expected(own + 8, 0, 0, 0, own + 8, 0, 0, 0, own + 16);
    expected[0][1] = expected[1][0] = -8.0;
    expect_near(mass.inertia, expected, 1e-12);
}

TEST(MassProperties, OfSpheresApproachTheClosedForms)
{
    const double r = 1.5, volume = 4.0 / 3.0 * std::numbers::pi * r * r * r, inertia = 0.4 * volume * r * r;
    double last = 1.0;
    for (const std::uint32_t frequency : {10u, 20u, 40u, 80u}) {
        const MassProperties mass = mass_properties(mesh_of(shapes::icosphere(1.5f, frequency)));
        const double error = 1.0 - mass.volume / volume;
        EXPECT_GT(error, 0.0);
        EXPECT_LT(error, 0.3 * last) << "second order: a quarter each time";
        last = error;
        expect_near(mass.inertia, glm::dmat3(inertia), 2.0 * error * inertia);
    }
}

TEST(MassProperties, OfAHollowSphereLeaveTheCavityOut)
{
    const TriangleSoup hollow = shapes::sphere_in_sphere(1.0f, 0.5f, 80);
    const MassProperties mass = mass_properties(mesh_of(moved(hollow, {1, 2, 3})));
    EXPECT_NEAR(mass.volume, 4.0 / 3.0 * std::numbers::pi * (1.0 - 0.125), 2e-3);
    EXPECT_NEAR(glm::length(mass.centre - glm::dvec3(1, 2, 3)), 0.0, 1e-6);
    expect_near(mass.inertia, glm::dmat3(8.0 / 15.0 * std::numbers::pi * (1.0 - 0.03125)), 2e-3);
}

TEST(MassProperties, OfAnInsideOutMeshAreNegative)
{
    TriangleSoup soup = moved(shapes::box(glm::vec3(2.0f), glm::uvec3(1)), {5, 0, 0});
    for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
    const MassProperties mass = mass_properties(mesh_of(soup));
    EXPECT_NEAR(mass.volume, -8.0, 1e-12);
    EXPECT_NEAR(mass.centre.x, 5.0, 1e-12);
    expect_near(mass.inertia, -box_inertia(glm::dvec3(2.0)), 1e-11);
}

TEST(MassProperties, WithoutVolumeHaveTheReferenceAsCentre)
{
    IndexedMesh empty;
    EXPECT_EQ(mass_properties(empty).volume, 0.0);
    EXPECT_EQ(mass_properties(empty).centre, glm::dvec3(0.0));
    // A triangle and its back.
    IndexedMesh flat;
    flat.vertices = {{{100, 0, 0}, {}, {}}, {{101, 0, 0}, {}, {}}, {{100, 1, 0}, {}, {}}};
    flat.triangles = {{0, 1, 2}, {2, 1, 0}};
    EXPECT_EQ(mass_properties(flat).volume, 0.0);
    EXPECT_EQ(mass_properties(flat).centre, glm::dvec3(100.5, 0.5, 0.0));
    expect_near(mass_properties(flat).inertia, glm::dmat3(0.0), 0.0);
}

TEST(MassReference, IsTheOriginNearTheOriginAndTheCentreElsewhere)
{
    EXPECT_EQ(mass_reference(Box{}), glm::dvec3(0.0));
    EXPECT_EQ(mass_reference({glm::vec3(-1.0f), glm::vec3(2.0f)}), glm::dvec3(0.0));
    EXPECT_EQ(mass_reference({glm::vec3(9.0f), glm::vec3(11.0f)}), glm::dvec3(10.0));
}

RC_GTEST_PROP(MassMoments, AddUpOverAnyDivisionOfTheTriangles, ())
{
    const TriangleSoup soup = shapes::asteroid(500, *rc::gen::inRange<std::uint64_t>(0, 1000));
    const auto number = [] { return double(*rc::gen::inRange(-100, 100)) / 10.0; };
    const glm::dvec3 reference{number(), number(), number()};
    const std::size_t cut = *rc::gen::inRange<std::size_t>(0, soup.triangles.size());
    const std::span<const Triangle> triangles(soup.triangles);

    MassMoments parts = mass_moments(soup.vertices, triangles.first(cut), reference);
    parts.add(mass_moments(soup.vertices, triangles.subspan(cut), reference));
    MassMoments single;
    for (const Triangle& t : triangles) {
        single.add(reference, soup.vertices[t[0]].position, soup.vertices[t[1]].position, soup.vertices[t[2]].position);
    }
    const MassMoments whole = mass_moments(soup.vertices, triangles, reference);
    for (const MassMoments& other : {parts, single}) {
        const MassProperties a = whole.properties(reference), b = other.properties(reference);
        RC_ASSERT(std::abs(a.volume - b.volume) < 1e-10);
        RC_ASSERT(glm::length(a.centre - b.centre) < 1e-9);
        for (int i = 0; i < 3; ++i) RC_ASSERT(glm::length(a.inertia[i] - b.inertia[i]) < 1e-8);
    }
}

RC_GTEST_PROP(MassMoments, AreTheSameBitsOnEveryProcessor, ())
{
    const TriangleSoup soup = shapes::asteroid(100, *rc::gen::inRange<std::uint64_t>(0, 1000));
    const double x = double(*rc::gen::inRange(-2, 3));
    const glm::dvec3 reference{x, 0.5 * x, -0.1 * x};
    const auto triangles =
        std::span<const Triangle>(soup.triangles).first(*rc::gen::inRange<std::size_t>(0, soup.triangles.size()));
    const MassMoments wide = mass_moments(soup.vertices, triangles, reference);
    const WithoutAvx2 without;
    const MassMoments narrow = mass_moments(soup.vertices, triangles, reference);
    RC_ASSERT(wide.volume6 == narrow.volume6);
    RC_ASSERT(wide.first24 == narrow.first24);
    RC_ASSERT(wide.squares120 == narrow.squares120);
    RC_ASSERT(wide.products120 == narrow.products120);
}

RC_GTEST_PROP(MassMoments, OfAClosedMeshDoNotDependOnTheReference, ())
{
    const TriangleSoup soup = shapes::asteroid(500, *rc::gen::inRange<std::uint64_t>(0, 1000));
    const auto number = [] { return double(*rc::gen::inRange(-100, 100)) / 10.0; };
    const glm::dvec3 reference{number(), number(), number()};
    const MassProperties a = mass_moments(soup.vertices, soup.triangles, reference).properties(reference);
    const MassProperties b = mass_moments(soup.vertices, soup.triangles, glm::dvec3(0.0)).properties(glm::dvec3(0.0));
    RC_ASSERT(std::abs(a.volume - b.volume) < 1e-10);
    RC_ASSERT(glm::length(a.centre - b.centre) < 1e-9);
    for (int i = 0; i < 3; ++i) RC_ASSERT(glm::length(a.inertia[i] - b.inertia[i]) < 1e-8);
}

RC_GTEST_PROP(MassMoments, OfATetrahedronMatchNumericalIntegration, ())
{
    // The second moment along x about the reference by the exact rule on the four corners and the centroid:
    // integral of a quadratic = V * (sum over corners / 20 + 4/5 at the centroid).
    const auto number = [] { return float(*rc::gen::inRange(-50, 50)) / 8.0f; };
    const glm::vec3 a{number(), number(), number()}, b{number(), number(), number()}, c{number(), number(), number()};
    const glm::dvec3 reference{number(), number(), number()};
    MassMoments moments;
    moments.add(reference, a, b, c);
    const glm::dvec3 p = glm::dvec3(a) - reference, q = glm::dvec3(b) - reference, r = glm::dvec3(c) - reference;
    const double volume = glm::dot(p, glm::cross(q, r)) / 6.0;
    const auto integral = [&](auto f) {
        return volume * ((f(glm::dvec3(0.0)) + f(p) + f(q) + f(r)) / 20.0 + 0.8 * f((p + q + r) / 4.0));
    };
    const auto near = [&](double x, double y) { return std::abs(x - y) < 1e-8 * (1.0 + std::abs(y)); };
    RC_ASSERT(near(moments.volume6 / 6.0, volume));
    RC_ASSERT(near(moments.first24.y / 24.0, integral([](const glm::dvec3& x) { return x.y; })));
    RC_ASSERT(near(moments.squares120.x / 120.0, integral([](const glm::dvec3& x) { return x.x * x.x; })));
    RC_ASSERT(near(moments.squares120.z / 120.0, integral([](const glm::dvec3& x) { return x.z * x.z; })));
    RC_ASSERT(near(moments.products120.x / 120.0, integral([](const glm::dvec3& x) { return x.y * x.z; })));
    RC_ASSERT(near(moments.products120.y / 120.0, integral([](const glm::dvec3& x) { return x.z * x.x; })));
    RC_ASSERT(near(moments.products120.z / 120.0, integral([](const glm::dvec3& x) { return x.x * x.y; })));
}

}  // namespace
}  // namespace kerf::core
