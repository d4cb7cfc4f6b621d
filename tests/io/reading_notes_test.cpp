#include "common/io/reading_notes.h"

#include <gtest/gtest.h>

#include <string>

namespace kerf::io {
namespace {

TEST(ReadingNotes, CountOneKindTogetherInTheOrderOfTheirFirst)
{
    ReadingNotes notes;
    EXPECT_TRUE(notes.none());
    EXPECT_EQ(notes.describe(), "");
    notes.add("apples");
    notes.add("pears", 0);
    notes.add("nuts", 3);
    notes.add("apples", 4);
    ASSERT_EQ(notes.list().size(), 2u);
    EXPECT_EQ(notes.list()[0].what, "apples");
    EXPECT_EQ(notes.list()[0].count, 5u);
    EXPECT_EQ(notes.describe(), "5 apples, 3 nuts");
}

TEST(ReadingNotes, CountAllKindsBeyondABoundAsOne)
{
    ReadingNotes notes;
    for (int i = 0; i < 1000; ++i) notes.add("kind " + std::to_string(i));
    notes.add("kind 1");
    ASSERT_EQ(notes.list().size(), 33u);
    EXPECT_EQ(notes.list()[1].count, 2u);
    EXPECT_EQ(notes.list().back().what, "other things passed over");
    EXPECT_EQ(notes.list().back().count, 968u);
}

}  // namespace
}  // namespace kerf::io
