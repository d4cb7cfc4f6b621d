#include "common/fracture/split_into_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "support/fixtures.h"

namespace kerf::core {
namespace {

/// A mesh by its points.
struct Solid
{
    std::vector<glm::vec3> points;
    std::vector<PointTriple> triangles;
    Box bounds;

    explicit Solid(const IndexedMesh& mesh) : points(mesh.point_count), bounds(mesh.bounds())
    {
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) points[mesh.points[v]] = mesh.vertices[v].position;
        for (const Triangle& t : mesh.triangles)
            triangles.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
    }

    double size() const { return glm::length(glm::dvec3(bounds.hi) - glm::dvec3(bounds.lo)); }
};

std::vector<glm::dvec3> random_sites(const Box& bounds, std::size_t count, test::Random& random)
{
    std::vector<glm::dvec3> sites;
    const glm::dvec3 lo(bounds.lo), size = glm::dvec3(bounds.hi) - lo;
    while (sites.size() < count)
        sites.push_back(lo + size * glm::dvec3(random.uniform(), random.uniform(), random.uniform()));
    return sites;
}

/// What closes a cell: parts of the surface, and contacts, those of the second cell turned over.
std::vector<std::array<glm::vec3, 3>> shell_of(const SplitSolid& split, const Solid& solid, std::uint32_t cell)
{
    const auto at = [&](std::uint32_t p) {
        return p < solid.points.size() ? solid.points[p] : split.new_points[p - solid.points.size()];
    };
    std::vector<std::array<glm::vec3, 3>> shell;
    for (const PartTriangle& part : split.parts[cell])
        shell.push_back({at(part.corners[0]), at(part.corners[1]), at(part.corners[2])});
    for (const Contact& contact : split.contacts)
        for (const auto& [a, b, c] : contact.triangles) {
            if (contact.cells[0] == cell) shell.push_back({at(a), at(b), at(c)});
            if (contact.cells[1] == cell) shell.push_back({at(a), at(c), at(b)});
        }
    return shell;
}

double volume_of(const std::vector<std::array<glm::vec3, 3>>& shell)
{
    double volume = 0.0;
    for (const auto& [a, b, c] : shell)
        volume += glm::dot(glm::dvec3(a), glm::cross(glm::dvec3(b), glm::dvec3(c))) / 6.0;
    return volume;
}

/// Edges along which triangles run one way more often than the other; points of one place are one.
std::size_t open_edges(const std::vector<std::array<glm::vec3, 3>>& shell)
{
    const auto key = [](const glm::vec3& p) { return std::array{p.x, p.y, p.z}; };
    std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> balance;
    for (const auto& corners : shell)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto a = key(corners[i]), b = key(corners[(i + 1) % 3]);
            if (a < b) ++balance[{a, b}];
            if (b < a) --balance[{b, a}];
        }
    return static_cast<std::size_t>(std::ranges::count_if(balance, [](const auto& edge) { return edge.second != 0; }));
}

class SplitIntoCells : public testing::TestWithParam<std::string>
{
};

TEST_P(SplitIntoCells, CellsAreClosedAndFillTheWhole)
{
    const Solid solid(test::closed_shape(GetParam()));
    std::vector<std::array<glm::vec3, 3>> whole;
    for (const auto& [a, b, c] : solid.triangles) whole.push_back({solid.points[a], solid.points[b], solid.points[c]});
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        const auto sites = random_sites(solid.bounds, 1 + random.below(40), random);
        const auto split = split_into_cells(solid.points, solid.triangles, sites);
        ASSERT_TRUE(split) << "seed " << seed;
        double sum = 0.0;
        for (std::uint32_t cell = 0; cell < sites.size(); ++cell) {
            const auto shell = shell_of(*split, solid, cell);
            EXPECT_EQ(open_edges(shell), 0u) << "seed " << seed << ", cell " << cell;
            sum += volume_of(shell);
        }
        EXPECT_NEAR(sum, volume_of(whole), 1e-6 * std::abs(volume_of(whole))) << "seed " << seed;
    }
}

TEST_P(SplitIntoCells, EachPlaceBelongsToTheNearestSite)
{
    const Solid solid(test::closed_shape(GetParam()));
    test::Random random(7);
    const auto sites = random_sites(solid.bounds, 25, random);
    const auto split = split_into_cells(solid.points, solid.triangles, sites);
    ASSERT_TRUE(split);
    const double tolerance = 1e-5 * solid.size();
    for (std::uint32_t cell = 0; cell < sites.size(); ++cell)
        for (const auto& corners : shell_of(*split, solid, cell))
            for (const glm::vec3& corner : corners) {
                const double own = glm::distance(glm::dvec3(corner), sites[cell]);
                for (const glm::dvec3& other : sites)
                    EXPECT_GE(glm::distance(glm::dvec3(corner), other), own - tolerance);
            }
    for (const Contact& contact : split->contacts)
        for (const PointTriple& triangle : contact.triangles)
            for (const std::uint32_t p : triangle) {
                const glm::dvec3 at(p < solid.points.size() ? solid.points[p]
                                                            : split->new_points[p - solid.points.size()]);
                EXPECT_NEAR(glm::distance(at, sites[contact.cells[0]]), glm::distance(at, sites[contact.cells[1]]),
                            tolerance);
            }
}

TEST_P(SplitIntoCells, PartsLieInTheTrianglesThatTheyName)
{
    const Solid solid(test::closed_shape(GetParam()));
    test::Random random(3);
    const auto sites = random_sites(solid.bounds, 30, random);
    const auto split = split_into_cells(solid.points, solid.triangles, sites);
    ASSERT_TRUE(split);
    std::vector<double> area(solid.triangles.size(), 0.0);
    const auto cross = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    };
    const auto at = [&](std::uint32_t p) {
        return p < solid.points.size() ? solid.points[p] : split->new_points[p - solid.points.size()];
    };
    const auto normal_of = [&](std::uint32_t t) {
        const auto& [a, b, c] = solid.triangles[t];
        return cross(solid.points[a], solid.points[b], solid.points[c]);
    };
    for (const auto& parts : split->parts)
        for (const auto& [corners, source] : parts) {
            const glm::dvec3 normal = normal_of(source);
            area[source] +=
                glm::dot(cross(at(corners[0]), at(corners[1]), at(corners[2])), normal) / glm::length(normal);
        }
    for (std::uint32_t t = 0; t < area.size(); ++t)
        EXPECT_NEAR(area[t], glm::length(normal_of(t)), 1e-6 * solid.size() * solid.size());
}

INSTANTIATE_TEST_SUITE_P(Shapes, SplitIntoCells, testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const test::NamedMesh& shape : test::closed_shapes())
                                 if (shape.name != "overlapping_spheres") names.push_back(shape.name);
                             return names;
                         }()),
                         [](const auto& param) {
                             std::string name = param.param;
                             std::ranges::replace_if(
                                 name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                             return name;
                         });

TEST(SplitIntoCellsOnce, TheSameInputGivesTheSameBytes)
{
    const Solid solid(test::closed_shape(test::closed_shapes().front().name));
    test::Random random(5);
    const auto sites = random_sites(solid.bounds, 50, random);
    const auto one = split_into_cells(solid.points, solid.triangles, sites);
    const auto other = split_into_cells(solid.points, solid.triangles, sites);
    ASSERT_TRUE(one && other);
    EXPECT_EQ(one->new_points, other->new_points);
    ASSERT_EQ(one->contacts.size(), other->contacts.size());
    for (std::size_t i = 0; i < one->contacts.size(); ++i)
        EXPECT_EQ(one->contacts[i].triangles, other->contacts[i].triangles);
}

TEST(SplitIntoCellsOnce, OneSiteTakesAll)
{
    const Solid solid(test::closed_shape(test::closed_shapes().front().name));
    const glm::dvec3 far_away[] = {{100.0, 200.0, 300.0}};
    const auto split = split_into_cells(solid.points, solid.triangles, far_away);
    ASSERT_TRUE(split);
    EXPECT_EQ(split->parts[0].size(), solid.triangles.size());
    EXPECT_TRUE(split->contacts.empty());
    EXPECT_TRUE(split->new_points.empty());
}

TEST(SplitIntoCellsOnce, SitesInAGridAreRefusedWhereMoreThanFourCellsMeet)
{
    const Solid solid(test::closed_shape(test::closed_shapes().front().name));
    std::vector<glm::dvec3> sites;
    for (const double x : {-0.125, 0.0, 0.125})
        for (const double y : {-0.125, 0.0, 0.125})
            for (const double z : {-0.125, 0.0, 0.125}) sites.emplace_back(x, y, z);
    EXPECT_FALSE(split_into_cells(solid.points, solid.triangles, sites));
}

TEST(SplitIntoCellsOnce, ASurfaceThatPassesThroughItselfIsRefused)
{
    const Solid solid(test::closed_shape("overlapping_spheres"));
    test::Random random(1);
    EXPECT_FALSE(split_into_cells(solid.points, solid.triangles, random_sites(solid.bounds, 40, random)));
}

TEST(SplitIntoCellsOnce, TrianglesOfOneCellAreTakenWhole)
{
    const Solid solid(test::closed_shape("asteroid"));
    test::Random random(9);
    const auto sites = random_sites(solid.bounds, 12, random);
    const auto split = split_into_cells(solid.points, solid.triangles, sites);
    ASSERT_TRUE(split);
    std::set<std::uint32_t> whole;
    std::uint64_t parts = 0;
    for (const auto& some : split->parts)
        for (const auto& [corners, source] : some) {
            ++parts;
            if (corners == solid.triangles[source]) whole.insert(source);
        }
    EXPECT_EQ(whole.size() + split->crossing_triangles, solid.triangles.size());
    EXPECT_GT(parts, solid.triangles.size());
}

}  // namespace
}  // namespace kerf::core
