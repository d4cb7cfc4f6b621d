#include "viewer/app/proxy_lines.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "viewer/support/stages.h"

namespace kerf::test {

using sim::CollisionProxy, sim::ProxyKind;

namespace {

CollisionProxy proxy_of_ball(ProxyKind kind)
{
    return sim::body_proxy(object_of(shape("icosphere", 320)), kind);
}

std::vector<glm::vec3> lines_of(ProxyKind kind, const glm::mat4& model = glm::mat4(1.0f))
{
    std::vector<glm::vec3> lines;
    app::append_proxy_lines(proxy_of_ball(kind), model, lines);
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
    const CollisionProxy proxy = proxy_of_ball(ProxyKind::sphere);
    const std::vector<glm::vec3> lines = lines_of(ProxyKind::sphere);
    ASSERT_FALSE(lines.empty());
    for (const glm::vec3& p : lines) EXPECT_NEAR(glm::distance(p, proxy.centre), proxy.radius, 1e-5f);
}

TEST(ProxyLines, HullShowsEachEdgeOnce)
{
    for (const ProxyKind kind : {ProxyKind::bounded_hull, ProxyKind::full_hull}) {
        const CollisionProxy proxy = proxy_of_ball(kind);
        // Euler: a closed hull of f triangles has 3 f / 2 edges.
        EXPECT_EQ(lines_of(kind).size(), 2 * (proxy.hull->indices().size() / 2));
    }
}

TEST(ProxyLines, HullWithoutFacesShowsItsPoints)
{
    CollisionProxy proxy = proxy_of_ball(ProxyKind::full_hull);
    proxy.kind = ProxyKind::points;
    proxy.hull.reset();
    std::vector<glm::vec3> lines;
    app::append_proxy_lines(proxy, glm::mat4(1.0f), lines);
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
