#include "halfedge/universe/ids.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace kerf::core::halfedge {
namespace {

template <class A, class B>
constexpr bool kMayBeTakenForOneAnother =
    std::is_convertible_v<A, B> || std::is_convertible_v<B, A> || std::is_assignable_v<A&, B>;

TEST(Ids, OfDifferentKindsAreNotTakenForOneAnother)
{
    static_assert(!kMayBeTakenForOneAnother<SlotId, NodeId>);
    static_assert(!kMayBeTakenForOneAnother<SlotId, GroupId>);
    static_assert(!kMayBeTakenForOneAnother<FaceId, HalfedgeId>);
    static_assert(!kMayBeTakenForOneAnother<FaceId, PointId>);
    static_assert(!kMayBeTakenForOneAnother<SlotId, Index>);
    static_assert(!kMayBeTakenForOneAnother<FaceId, int>);
}

TEST(Ids, CostNoMoreThanANumber)
{
    static_assert(sizeof(SlotId) == sizeof(Index) && sizeof(FaceId) == sizeof(Index));
    static_assert(std::is_trivially_copyable_v<SlotId> && std::is_trivially_copyable_v<FaceId>);
}

TEST(Ids, AreNoneUntilTheyAreSet)
{
    EXPECT_FALSE(NodeId().is_valid());
    EXPECT_FALSE(HalfedgeId().is_valid());
    EXPECT_TRUE(NodeId(0).is_valid());
    EXPECT_EQ(number_of(HalfedgeId()), kNone);
    EXPECT_EQ(NodeId().number(), kNone);
}

TEST(Ids, CountOnLikeNumbers)
{
    SlotId slot(5);
    EXPECT_EQ(slot++, SlotId(5));
    EXPECT_EQ(++slot, SlotId(7));
    EXPECT_EQ(slot + 3, SlotId(10));
    EXPECT_EQ(SlotId(10) - slot, 3u);
    EXPECT_LT(slot, SlotId(8));
}

TEST(Ids, HalfEdgesOfAnEdgeAreOppositeToEachOther)
{
    for (int e = 0; e < 5; ++e) {
        const HalfedgeId first = first_halfedge(EdgeId(e)), second = opposite(first);
        EXPECT_NE(first, second);
        EXPECT_EQ(opposite(second), first);
        for (const HalfedgeId h : {first, second}) EXPECT_EQ(edge_of(h), EdgeId(e));
    }
}

}  // namespace
}  // namespace kerf::core::halfedge
