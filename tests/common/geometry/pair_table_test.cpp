#include "common/geometry/pair_table.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace kerf::core {
namespace {

TEST(PairTable, KnowsNothingAtFirst)
{
    const PairTable table;
    EXPECT_EQ(table.find(0, 0), kNone);
    EXPECT_EQ(table.find(3, 7), kNone);
}

TEST(PairTable, TellsAPairFromItsReverse)
{
    PairTable table;
    table(1, 2) = 10;
    table(2, 1) = 20;
    EXPECT_EQ(table.find(1, 2), 10u);
    EXPECT_EQ(table.find(2, 1), 20u);
}

TEST(PairTable, IsEmptyAfterReset)
{
    PairTable table;
    table(5, 6) = 1;
    table.reset(4);
    EXPECT_EQ(table.find(5, 6), kNone);
    EXPECT_EQ(table(5, 6), kNone);
}

RC_GTEST_PROP(PairTable, HoldsWhatAMapHoldsHoweverLittleRoomWasAskedFor, ())
{
    const auto room = *rc::gen::inRange<std::size_t>(0, 64);
    const auto small = rc::gen::inRange<std::uint32_t>(0, 24);
    const auto pairs =
        *rc::gen::resize(rc::kNominalSize * 4, rc::gen::container<std::vector<std::pair<std::uint32_t, std::uint32_t>>>(
                                                   rc::gen::pair(rc::gen::resize(rc::kNominalSize, small), small)));
    PairTable table;
    table.reset(room);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> expected;
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        std::uint32_t& value = table(pairs[i].first, pairs[i].second);
        const auto [entry, is_new] = expected.try_emplace(pairs[i], i);
        RC_ASSERT(value == (is_new ? kNone : entry->second));
        value = entry->second;
    }
    for (std::uint32_t a = 0; a < 24; ++a)
        for (std::uint32_t b = 0; b < 24; ++b) {
            const auto entry = expected.find({a, b});
            RC_ASSERT(table.find(a, b) == (entry == expected.end() ? kNone : entry->second));
        }
}

}  // namespace
}  // namespace kerf::core
