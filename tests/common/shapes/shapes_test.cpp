#include "common/shapes/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/mesh/box.h"
#include "support/brief.h"
#include "support/surface_facts.h"

namespace kerf::core {
namespace {

using test::surface_facts;
using test::SurfaceFacts;

std::uint64_t hash_of(const TriangleSoup& soup)
{
    std::uint64_t hash = 0xCBF29CE484222325u;  // FNV-1a
    const auto add = [&](const void* data, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) {
            hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001B3u;
        }
    };
    add(soup.vertices.data(), soup.vertices.size() * sizeof(Vertex));
    add(soup.triangles.data(), soup.triangles.size() * sizeof(Triangle));
    return hash;
}

void expect_well_made(const TriangleSoup& soup, std::size_t shells, long euler_of_a_shell)
{
    const SurfaceFacts facts = surface_facts(soup);
    EXPECT_EQ(facts.unpaired_edges, 0u);
    EXPECT_EQ(facts.degenerate, 0u);
    EXPECT_EQ(facts.flat, 0u);
    EXPECT_EQ(facts.pinched_points, 0u);
    EXPECT_EQ(facts.unused_vertices, 0u);
    EXPECT_EQ(facts.bad_normals, 0u);
    EXPECT_EQ(facts.backward_normals, 0u);
    EXPECT_EQ(facts.bad_numbers, 0u);
    EXPECT_EQ(facts.shells, shells);
    EXPECT_EQ(facts.euler(), euler_of_a_shell * long(shells));
    EXPECT_GT(facts.volume, 0.0);
}

class EveryShape : public testing::TestWithParam<std::string>
{
};

TEST_P(EveryShape, IsClosedManifoldAndOutsideOutAtAnySize)
{
    for (const std::uint64_t triangles : {0, 100, 1000, 20000}) {
        SCOPED_TRACE(triangles);
        const std::optional<TriangleSoup> soup = shapes::make(GetParam(), triangles, 1);
        ASSERT_TRUE(soup);
        const SurfaceFacts facts = surface_facts(*soup);
        EXPECT_EQ(facts.unpaired_edges, 0u);
        EXPECT_EQ(facts.degenerate, 0u);
        EXPECT_EQ(facts.flat, 0u);
        EXPECT_EQ(facts.pinched_points, 0u);
        EXPECT_EQ(facts.unused_vertices, 0u);
        EXPECT_EQ(facts.bad_normals, 0u);
        EXPECT_EQ(facts.bad_numbers, 0u);
        EXPECT_GT(facts.volume, 0.0);
    }
}

TEST_P(EveryShape, HasAboutTheTrianglesAskedFor)
{
    for (const std::uint64_t triangles : {1000, 20000, 200000}) {
        const double ratio = double(shapes::make(GetParam(), triangles, 1)->triangles.size()) / double(triangles);
        const double limit = GetParam() == "menger_sponge" ? std::sqrt(20.0) : 1.25;
        EXPECT_LT(ratio, limit) << triangles;
        EXPECT_GT(ratio, 1.0 / limit) << triangles;
    }
}

TEST_P(EveryShape, IsTheSameEveryTime)
{
    EXPECT_EQ(hash_of(*shapes::make(GetParam(), 5000, 7)), hash_of(*shapes::make(GetParam(), 5000, 7)));
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(shapes::names()),
                         [](const auto& shape) { return shape.param; });

TEST(Shapes, AnUnknownNameGivesNothing)
{
    EXPECT_FALSE(shapes::make("teapot", 1000, 1));
    EXPECT_FALSE(shapes::make("", 1000, 1));
    EXPECT_TRUE(std::is_sorted(shapes::names().begin(), shapes::names().end()));
}

TEST(Shapes, RaiseCountsThatAreTooSmall)
{
    expect_well_made(shapes::icosphere(1.0f, 0), 1, 2);
    expect_well_made(shapes::uv_sphere(1.0f, 0, 0), 1, 2);
    expect_well_made(shapes::box(glm::vec3(1.0f), glm::uvec3(0)), 1, 2);
    expect_well_made(shapes::cylinder(1.0f, 1.0f, 0, 0), 1, 2);
    expect_well_made(shapes::cone(1.0f, 1.0f, 0), 1, 2);
    expect_well_made(shapes::torus(1.0f, 0.3f, 0, 0), 1, 0);
    expect_well_made(shapes::pipe(1.0f, 0.5f, 1.0f, 0, 0), 1, 0);
    expect_well_made(shapes::comb(0), 1, 2);
    expect_well_made(shapes::l_step(0), 1, 2);
    expect_well_made(shapes::two_legs(0), 1, 2);
    expect_well_made(shapes::tray(0), 1, 2);
    EXPECT_TRUE(surface_facts(shapes::bowl(1.0f, 0.2f, 0, 0)).closed_and_manifold());
    EXPECT_TRUE(surface_facts(shapes::spiral_wall(0.0f, 0)).closed_and_manifold());
    EXPECT_EQ(shapes::asteroid(0, 1).triangles.size(), 12u);
}

TEST(Icosphere, ApproachesTheSphere)
{
    for (const std::uint32_t f : {1u, 2u, 3u, 5u, 8u, 40u}) {
        SCOPED_TRACE(f);
        const TriangleSoup soup = shapes::icosphere(2.0f, f);
        EXPECT_EQ(soup.triangles.size(), 20u * f * f);
        expect_well_made(soup, 1, 2);
        for (const Vertex& v : soup.vertices) ASSERT_NEAR(glm::length(glm::dvec3(v.position)), 2.0, 3e-7);
    }
    EXPECT_NEAR(surface_facts(shapes::icosphere(2.0f, 100)).volume, 32.0 * std::numbers::pi / 3.0, 0.01);
    EXPECT_NEAR(surface_facts(shapes::icosphere(1.0f, 1)).area,
                20.0 * std::sqrt(3.0) / 4.0 * 1.05146222424 * 1.05146222424, 1e-5);
}

TEST(UvSphere, HasPolesAndASeam)
{
    const TriangleSoup soup = shapes::uv_sphere(1.0f, 40, 20);
    EXPECT_EQ(soup.triangles.size(), 2u * 40 * 19);
    expect_well_made(soup, 1, 2);
    EXPECT_EQ(surface_facts(soup).points, 40u * 19 + 2);
    EXPECT_EQ(soup.vertices.size(), 41u * 19 + 2 * 40);
    expect_well_made(shapes::uv_sphere(1.0f, 3, 2), 1, 2);
}

TEST(Box, IsExact)
{
    const TriangleSoup soup = shapes::box({1, 2, 4}, {3, 2, 5});
    EXPECT_EQ(soup.triangles.size(), 4u * (6 + 10 + 15));
    EXPECT_NEAR(surface_facts(soup).volume, 8.0, 1e-6);
    EXPECT_NEAR(surface_facts(soup).area, 28.0, 1e-5);
    expect_well_made(soup, 1, 2);
    expect_well_made(shapes::box({1, 1, 1}, {1, 1, 1}), 1, 2);
    EXPECT_EQ(shapes::box({1, 1, 1}, {1, 1, 1}).vertices.size(), 24u);
}

TEST(Lathe, MakesCylindersConesToriPipesAndBowls)
{
    // What an inscribed polygon with n corners leaves of a circle's area.
    const auto polygon = [](double n) { return n / 2.0 * std::sin(2.0 * std::numbers::pi / n); };

    const TriangleSoup cylinder = shapes::cylinder(0.5f, 2.0f, 30, 4);
    EXPECT_EQ(cylinder.triangles.size(), 2u * 30 * 5);
    EXPECT_EQ(shapes::cylinder(0.5f, 2.0f, 31).triangles.size(), 4u * 31);
    EXPECT_NEAR(surface_facts(cylinder).volume, 2.0 * 0.25 * polygon(30), 1e-6);
    expect_well_made(cylinder, 1, 2);

    const TriangleSoup cone = shapes::cone(0.5f, 2.0f, 30);
    EXPECT_EQ(cone.triangles.size(), 2u * 30);
    EXPECT_NEAR(surface_facts(cone).volume, 2.0 / 3.0 * 0.25 * polygon(30), 1e-6);
    expect_well_made(cone, 1, 2);

    const TriangleSoup torus = shapes::torus(2.0f, 0.5f, 200, 100);
    EXPECT_EQ(torus.triangles.size(), 2u * 200 * 100);
    EXPECT_NEAR(surface_facts(torus).volume, 2.0 * std::numbers::pi * std::numbers::pi * 2.0 * 0.25, 0.02);
    expect_well_made(torus, 1, 0);

    const TriangleSoup pipe = shapes::pipe(0.5f, 0.25f, 2.0f, 30, 3);
    EXPECT_EQ(pipe.triangles.size(), 4u * 30 * 4);
    EXPECT_NEAR(surface_facts(pipe).volume, 2.0 * (0.25 - 0.0625) * polygon(30), 1e-6);
    expect_well_made(pipe, 1, 0);

    const TriangleSoup bowl = shapes::bowl(1.0f, 0.2f, 120, 60);
    EXPECT_EQ(bowl.triangles.size(), 4u * 120 * 60);
    EXPECT_NEAR(surface_facts(bowl).volume, 2.0 / 3.0 * std::numbers::pi * (1.0 - 0.8 * 0.8 * 0.8), 0.003);
    expect_well_made(bowl, 1, 2);
}

TEST(Blocks, MakeCombsStepsLegsAndTrays)
{
    for (const std::uint32_t teeth : {1u, 2u, 9u}) {
        const TriangleSoup comb = shapes::comb(teeth);
        EXPECT_EQ(comb.triangles.size(), 24u * teeth - 4);
        EXPECT_NEAR(surface_facts(comb).volume, 0.04 * (0.3 * (2 * teeth - 1) + 0.7 * teeth), 1e-5);
        expect_well_made(comb, 1, 2);
    }
    for (const std::uint32_t cells : {1u, 2u, 5u}) {
        EXPECT_EQ(shapes::l_step(cells).triangles.size(), 28u * cells * cells);
        EXPECT_NEAR(surface_facts(shapes::l_step(cells)).volume, 3.0, 1e-5);
        expect_well_made(shapes::l_step(cells), 1, 2);
        EXPECT_EQ(shapes::two_legs(cells).triangles.size(), 44u * cells * cells);
        EXPECT_NEAR(surface_facts(shapes::two_legs(cells)).volume, 5.0, 1e-5);
        expect_well_made(shapes::two_legs(cells), 1, 2);
        EXPECT_EQ(shapes::tray(cells).triangles.size(), 92u * cells * cells);
        EXPECT_NEAR(surface_facts(shapes::tray(cells)).volume, 17.0, 1e-5);
        expect_well_made(shapes::tray(cells), 1, 2);
    }
}

TEST(SpiralWall, HasConstantThickness)
{
    const TriangleSoup soup = shapes::spiral_wall(3.0f, 64);
    EXPECT_EQ(soup.triangles.size(), 8u * 3 * 64 + 4);
    expect_well_made(soup, 1, 2);
    // Thickness times height times the length of the centre line r = 0.2 + 0.2 angle / (2 pi), by the midpoint rule.
    double length = 0.0;
    constexpr int kSteps = 10000;
    for (int i = 0; i < kSteps; ++i) {
        const double step = 6.0 * std::numbers::pi / kSteps, angle = (i + 0.5) * step;
        length += step * std::hypot(0.2 + 0.2 * angle / (2.0 * std::numbers::pi), 0.2 / (2.0 * std::numbers::pi));
    }
    EXPECT_NEAR(surface_facts(soup).volume, 0.08 * 0.5 * length, 0.005 * length * 0.04);
}

TEST(MengerSponge, MeetsItsClosedForms)
{
    double volume = 1.0;
    long twenty = 1, eight = 1;
    for (std::uint32_t level = 0; level <= 3; ++level, volume *= 20.0 / 27.0, twenty *= 20, eight *= 8) {
        SCOPED_TRACE(level);
        const TriangleSoup soup = shapes::menger_sponge(level);
        EXPECT_EQ(soup.triangles.size(), std::size_t(4 * twenty + 8 * eight));
        // The genus of the boundary: 0, 5, 81, 1409.
        const long genus[] = {0, 5, 81, 1409};
        expect_well_made(soup, 1, 2 - 2 * genus[level]);
        EXPECT_NEAR(surface_facts(soup).volume, volume, 1e-5);
    }
}

TEST(MengerSponge, IsManifoldAtItsFinestLevel)
{
    const TriangleSoup soup = shapes::menger_sponge(4);
    EXPECT_EQ(soup.triangles.size(), 4u * 160000 + 8u * 4096);
    EXPECT_TRUE(surface_facts(soup).closed_and_manifold());
}

TEST(NestedSpheres, AlternateInsideAndOutside)
{
    const TriangleSoup hollow = shapes::sphere_in_sphere(1.0f, 0.5f, 30);
    EXPECT_EQ(hollow.triangles.size(), 40u * 30 * 30);
    expect_well_made(hollow, 2, 2);
    EXPECT_NEAR(surface_facts(hollow).volume, 4.0 / 3.0 * std::numbers::pi * (1.0 - 0.125), 0.01);

    const TriangleSoup ball_inside = shapes::nested_spheres(std::array{1.0f, 0.8f, 0.5f}, 30);
    expect_well_made(ball_inside, 3, 2);
    EXPECT_NEAR(surface_facts(ball_inside).volume, 4.0 / 3.0 * std::numbers::pi * (1.0 - 0.512 + 0.125), 0.01);
}

TEST(OverlappingSpheres, AreTwoWholeSpheres)
{
    const TriangleSoup soup = shapes::overlapping_spheres(1.0f, 0.7f, 30);
    expect_well_made(soup, 2, 2);
    EXPECT_NEAR(surface_facts(soup).volume, 8.0 / 3.0 * std::numbers::pi, 0.02);
    Box box;
    for (const Vertex& v : soup.vertices) box.add(v.position);
    EXPECT_NEAR(box.hi.x - box.lo.x, 2.7f, 0.01f);
    EXPECT_NEAR(box.hi.y - box.lo.y, 2.0f, 0.01f);
}

TEST(Asteroid, MeetsAnyEvenCountWithinFivePercent)
{
    constexpr std::uint64_t kStep = test::kBrief ? 26 : 2;
    for (std::uint64_t triangles = 100; triangles <= 3000; triangles += kStep) {
        const std::size_t got = shapes::asteroid(triangles, 3).triangles.size();
        EXPECT_EQ(got % 2, 0u);
        EXPECT_NEAR(double(got), double(triangles), 0.05 * double(triangles));
    }
    for (const std::uint64_t triangles : {10000, 30000, 100000, 300000, 1000000}) {
        if (test::kBrief && triangles > 100000) continue;
        const std::size_t got = shapes::asteroid(triangles, 3).triangles.size();
        EXPECT_EQ(got % 2, 0u);
        EXPECT_NEAR(double(got), double(triangles), 0.01 * double(triangles));
    }
}

TEST(Asteroid, IsAClosedLumpyBall)
{
    for (const std::uint64_t seed : {0, 1, 2, 3, 4, 5, 6, 7}) {
        SCOPED_TRACE(seed);
        const TriangleSoup soup = shapes::asteroid(20000, seed);
        expect_well_made(soup, 1, 2);
        double least = 9.0, most = 0.0;
        for (const Vertex& v : soup.vertices) {
            least = std::min(least, glm::length(glm::dvec3(v.position)));
            most = std::max(most, glm::length(glm::dvec3(v.position)));
            ASSERT_TRUE(v.uv.x >= 0.0f && v.uv.x <= 1.0f && v.uv.y >= 0.0f && v.uv.y <= 1.0f);
        }
        EXPECT_GT(least, 0.4);
        EXPECT_LT(most, 1.6);
        EXPECT_GT(most - least, 0.2) << "lumpy";
    }
}

TEST(Asteroid, NormalsAreThoseOfTheDisplacedSurface)
{
    const TriangleSoup soup = shapes::asteroid(400000, 5);
    double worst = 1.0;
    for (const Triangle& t : soup.triangles) {
        const Vertex &a = soup.vertices[t[0]], &b = soup.vertices[t[1]], &c = soup.vertices[t[2]];
        const glm::dvec3 face = glm::normalize(glm::cross(glm::dvec3(b.position) - glm::dvec3(a.position),
                                                          glm::dvec3(c.position) - glm::dvec3(a.position)));
        worst = std::min(
            worst, glm::dot(face, glm::normalize(glm::dvec3(a.normal) + glm::dvec3(b.normal) + glm::dvec3(c.normal))));
    }
    EXPECT_GT(worst, 0.98);
}

TEST(Asteroid, SeedsDiffer)
{
    EXPECT_NE(hash_of(shapes::asteroid(1000, 1)), hash_of(shapes::asteroid(1000, 2)));
}

TEST(Asteroid, ComesInACoherentOrder)
{
    const TriangleSoup soup = shapes::asteroid(100000, 1);
    std::uint32_t next = 0;
    for (const Triangle& t : soup.triangles) {
        for (const std::uint32_t v : t) {
            ASSERT_LE(v, next) << "numbered by first use";
            next = std::max(next, v + 1);
        }
    }
    // 64 triangles in a row cover a patch of about 8 x 8 / 2 cells: their boxes are small against the rock.
    double sum = 0.0;
    std::size_t runs = 0;
    for (std::size_t first = 0; first + 64 <= soup.triangles.size(); first += 64, ++runs) {
        Box box;
        for (std::size_t i = first; i < first + 64; ++i) {
            for (const std::uint32_t v : soup.triangles[i]) box.add(soup.vertices[v].position);
        }
        sum += glm::length(glm::dvec3(box.hi) - glm::dvec3(box.lo));
    }
    EXPECT_LT(sum / double(runs), 0.35);
}

TEST(Shuffled, KeepsTheTrianglesAndLosesTheOrder)
{
    TriangleSoup soup = shapes::uv_sphere(1.0f, 20, 10);
    soup.materials = {{"odd", {}, ""}, {"even", {}, ""}};
    VertexStream stream{"height", 1, {}};
    for (const Vertex& v : soup.vertices) stream.values.push_back(v.position.z);
    soup.streams.push_back(stream);
    // Material 1 for triangles that face up, so that a triangle tells which material it should have.
    const auto material = [](const TriangleSoup& s, const Triangle& t) {
        return s.vertices[t[0]].normal.z + s.vertices[t[1]].normal.z + s.vertices[t[2]].normal.z > 0 ? 1u : 0u;
    };
    for (const Triangle& t : soup.triangles) soup.triangle_materials.push_back(material(soup, t));

    const TriangleSoup mixed = shapes::shuffled(soup, 3);
    const auto sorted = [](const TriangleSoup& s) {
        std::vector<std::array<float, 24>> all;
        for (const Triangle& t : s.triangles) {
            std::array<float, 24> one;
            for (std::size_t k = 0; k < 3; ++k) std::memcpy(&one[8 * k], &s.vertices[t[k]], sizeof(Vertex));
            all.push_back(one);
        }
        std::sort(all.begin(), all.end());
        return all;
    };
    EXPECT_EQ(sorted(soup), sorted(mixed));
    EXPECT_NE(hash_of(soup), hash_of(mixed));
    EXPECT_EQ(hash_of(mixed), hash_of(shapes::shuffled(soup, 3)));
    EXPECT_NE(hash_of(mixed), hash_of(shapes::shuffled(soup, 4)));
    ASSERT_EQ(mixed.triangle_materials.size(), mixed.triangles.size());
    for (std::size_t i = 0; i < mixed.triangles.size(); ++i) {
        ASSERT_EQ(mixed.triangle_materials[i], material(mixed, mixed.triangles[i]));
    }
    for (std::size_t i = 0; i < mixed.vertices.size(); ++i) {
        ASSERT_EQ(mixed.streams[0].values[i], mixed.vertices[i].position.z);
    }
    EXPECT_EQ(mixed.materials.size(), 2u);
}

}  // namespace
}  // namespace kerf::core
