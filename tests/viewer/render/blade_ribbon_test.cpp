#include "viewer/render/blade_ribbon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace kerf::test {

using render::blade_ribbon;
using render::BladePoint;
using render::RibbonVertex;

TEST(BladeRibbon, NeedsTwoDifferentPoints)
{
    EXPECT_TRUE(blade_ribbon({}, 10.0f).empty());
    const std::vector<BladePoint> same(5, BladePoint{{3.0f, 4.0f}, 1.0f});
    EXPECT_TRUE(blade_ribbon(same, 10.0f).empty());
}

TEST(BladeRibbon, IsAsWideAsItsPointsAreYoung)
{
    const std::vector<BladePoint> path{{{0, 0}, 0.0f}, {{10, 0}, 0.5f}, {{20, 0}, 1.0f}};
    const std::vector<RibbonVertex> strip = blade_ribbon(path, 4.0f);
    ASSERT_EQ(strip.size(), 7u);  // two for each point, and the tip
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_FLOAT_EQ(glm::distance(strip[2 * i].place, strip[2 * i + 1].place), 4.0f * path[i].life);
        EXPECT_EQ(strip[2 * i].across, 1.0f);
        EXPECT_EQ(strip[2 * i + 1].across, -1.0f);
    }
    EXPECT_GT(strip.back().place.x, 20.0f);
    EXPECT_EQ(strip.back().across, 0.0f);
}

TEST(BladeRibbon, StaysFiniteWhereThePathTurnsBack)
{
    const std::vector<BladePoint> path{{{0, 0}, 0.2f}, {{10, 0}, 0.6f}, {{0, 0}, 1.0f}};
    for (const RibbonVertex& v : blade_ribbon(path, 4.0f)) {
        EXPECT_TRUE(std::isfinite(v.place.x));
        EXPECT_TRUE(std::isfinite(v.place.y));
    }
}

}  // namespace kerf::test
