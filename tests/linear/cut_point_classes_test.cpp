#include "linear/cut_point_classes.h"

#include <gtest/gtest.h>

namespace kerf::core {
namespace {

TEST(CutPointClasses, JoinWhatIsMergedDirectlyOrThroughOthers)
{
    CutPointClasses points;
    for (int i = 0; i < 4; ++i) points.add();
    points.merge(3, 2);
    points.merge(2, 1);
    EXPECT_EQ(points.find(3), 1u);
    EXPECT_EQ(points.find(0), 0u);
    EXPECT_EQ(points.existing(3), kNone);
}

TEST(CutPointClasses, KnowTheExistingPointOfAClass)
{
    CutPointClasses points;
    points.add();
    points.add();
    points.attach(1, 77);
    points.merge(0, 1);
    EXPECT_EQ(points.existing(0), 77u);
    EXPECT_EQ(points.standing_for(77), 77u);
    EXPECT_TRUE(points.joined().empty());
}

TEST(CutPointClasses, MakeExistingPointsOneThatOneCutPointLiesOn)
{
    CutPointClasses points;
    for (int i = 0; i < 3; ++i) points.add();
    points.attach(0, 9);
    points.attach(1, 5);
    points.attach(2, 7);
    points.merge(0, 1);
    points.merge(1, 2);
    for (std::uint32_t id = 0; id < 3; ++id) EXPECT_EQ(points.existing(id), 5u);
    for (const std::uint32_t point : {5u, 7u, 9u}) EXPECT_EQ(points.standing_for(point), 5u);
    EXPECT_EQ(points.joined().size(), 2u);
}

}  // namespace
}  // namespace kerf::core
