#include "viewer/ui/notice.h"

#include <gtest/gtest.h>

namespace kerf::test {

TEST(Notice, GoesAwayAfterSomeSeconds)
{
    ui::Notice notice;
    notice.say("The disk is full");
    const auto frames = static_cast<int>(60.0 * ui::Notice::kShown);
    for (int i = 0; i + 2 < frames; ++i) notice.advance(1.0 / 60.0);
    EXPECT_EQ(notice.text(), "The disk is full");
    for (int i = 0; i < 4; ++i) notice.advance(1.0 / 60.0);
    EXPECT_EQ(notice.text(), "");
}

TEST(Notice, StaysWhenThereIsNothingToSayAndThroughALongFrame)
{
    ui::Notice notice;
    notice.say("Sound off");
    notice.say("");
    notice.advance(100.0);
    EXPECT_EQ(notice.text(), "Sound off");
}

}  // namespace kerf::test
