#include "viewer/sim/input_queue.h"

#include <gtest/gtest.h>

namespace kerf::sim {
namespace {

InputEvent command(Microseconds time, const std::string& text)
{
    return {time, InputKind::command, {}, text};
}

}  // namespace

TEST(InputQueue, GivesEventsInTheOrderOfTheirTimesWhenTheyHaveCome)
{
    InputQueue queue(false);
    queue.push(command(time_of(3), "third"));
    queue.push(command(time_of(1), "first"));
    queue.push(command(time_of(1), "second"));
    EXPECT_FALSE(queue.take(0));
    EXPECT_EQ(queue.take(1)->text, "first");
    EXPECT_EQ(queue.take(1)->text, "second") << "of equal times the one that was pushed first";
    EXPECT_FALSE(queue.take(2));
    EXPECT_EQ(queue.take(3)->text, "third");
    EXPECT_FALSE(queue.take(3));
}

TEST(InputQueue, RecordsWhatWasPushedIfItIsToldTo)
{
    for (const bool records : {false, true}) {
        InputQueue queue(records);
        queue.push(command(time_of(2), "b"));
        queue.push(command(time_of(1), "a"));
        while (queue.take(2)) {
        }
        ASSERT_EQ(queue.recorded().size(), records ? 2u : 0u);
        if (records) {
            EXPECT_EQ(queue.recorded().front().text, "a");
        }
    }
}

TEST(InputQueue, TellsTheArgumentOfTheLastCommandThatIsDue)
{
    InputQueue queue(false);
    queue.push(command(time_of(1), "backend baseline"));
    queue.push(command(time_of(1), "backend halfedge"));
    queue.push(command(time_of(2), "backend baseline/scan"));
    queue.push(command(time_of(1), "backends"));
    EXPECT_EQ(queue.argument_of("backend", 1), "halfedge");
    EXPECT_EQ(queue.argument_of("backend", 2), "baseline/scan");
    EXPECT_EQ(queue.argument_of("proxy", 2), "");
}

}  // namespace kerf::sim
