#include "viewer/render/proxy_lines.h"
#include "common/proxy/collision_proxy.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include "support/fixtures.h"

namespace kerf::test {

namespace {

std::vector<glm::vec3> lines_of(ProxyKind kind, const glm::mat4& model = glm::mat4(1.0f))
{
    const IndexedMesh& mesh = closed_shape("icosphere");
    std::vector<glm::vec3> lines;
    render::append_proxy_lines(collision_proxy(kind, mesh.vertices), model, lines);
    return lines;
}

}  // namespace

TEST(ProxyLines, BoxHasTwelveEdgesAlongTheAxes)
{
    const std::vector<glm::vec3> lines = lines_of(ProxyKind::box);
    ASSERT_EQ(lines.size(), 24u);
    for (std::size_t i = 0; i < lines.size(); i += 2) {
        const glm::vec3 edge = lines[i + 1] - lines[i];
        EXPECT_EQ((edge.x != 0.0f) + (edge.y != 0.0f) + (edge.z != 0.0f), 1);
    }
}

TEST(ProxyLines, SphereIsThreeCirclesOfItsRadius)
{
    const CollisionProxy proxy = collision_proxy(ProxyKind::sphere, closed_shape("icosphere").vertices);
    const std::vector<glm::vec3> lines = lines_of(ProxyKind::sphere);
    ASSERT_FALSE(lines.empty());
    for (const glm::vec3& p : lines) EXPECT_NEAR(glm::distance(p, proxy.centre), proxy.radius, 1e-5f);
}

TEST(ProxyLines, HullShowsEachEdgeOnce)
{
    for (const ProxyKind kind : {ProxyKind::bounded_hull, ProxyKind::full_hull}) {
        const CollisionProxy proxy = collision_proxy(kind, closed_shape("icosphere").vertices);
        // Euler: a closed hull of f triangles has 3 f / 2 edges.
        EXPECT_EQ(lines_of(kind).size(), 2 * (3 * proxy.faces.size() / 2));
    }
}

TEST(ProxyLines, HullWithoutFacesShowsItsPoints)
{
    CollisionProxy proxy = collision_proxy(ProxyKind::full_hull, closed_shape("icosphere").vertices);
    proxy.kind = ProxyKind::points;
    proxy.faces.clear();
    std::vector<glm::vec3> lines;
    render::append_proxy_lines(proxy, glm::mat4(1.0f), lines);
    EXPECT_EQ(lines.size(), 6 * proxy.points.size());
}

TEST(ProxyLines, StandWhereTheObjectStands)
{
    const glm::mat4 model = glm::translate(glm::mat4(1.0f), glm::vec3(5.0f, 0.0f, 0.0f));
    const std::vector<glm::vec3> here = lines_of(ProxyKind::box), there = lines_of(ProxyKind::box, model);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i)
        EXPECT_LT(glm::distance(here[i] + glm::vec3(5.0f, 0.0f, 0.0f), there[i]), 1e-5f);
}

}  // namespace kerf::test
