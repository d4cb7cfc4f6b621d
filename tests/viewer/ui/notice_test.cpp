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

TEST(Notice, SaysOneThingAfterTheOther)
{
    ui::Notice notice;
    const auto pass = [&](double seconds) {
        for (int i = 0; i < static_cast<int>(60.0 * seconds) + 1; ++i) notice.advance(1.0 / 60.0);
        return notice.text();
    };
    notice.say_next("The scores are damaged");
    EXPECT_EQ(notice.text(), "The scores are damaged");
    notice.say_next("");
    notice.say_next("The settings are damaged");
    notice.say_next("The disk is full");
    EXPECT_EQ(pass(0.9 * ui::Notice::kShown), "The scores are damaged");
    notice.say("Sound off");
    EXPECT_EQ(pass(0.9 * ui::Notice::kShown), "Sound off") << "what the player does is answered at once";
    EXPECT_EQ(pass(0.2 * ui::Notice::kShown), "The settings are damaged");
    EXPECT_EQ(pass(ui::Notice::kShown), "The disk is full");
    EXPECT_EQ(pass(ui::Notice::kShown), "");
}

}  // namespace kerf::test
