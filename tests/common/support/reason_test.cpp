#include "common/support/reason.h"

#include <gtest/gtest.h>

namespace kerf::core {
namespace {

TEST(Reason, QuotesWordsWithoutControlCharacters)
{
    EXPECT_EQ(in_quotes("word"), "'word'");
    for (const char c : in_quotes("a\nb\x01\x7f")) EXPECT_GE(c, ' ');
}

TEST(Reason, CutsQuotedWordsBetweenLetters)
{
    const std::string letter = "\xF0\x9F\x98\x80";
    for (std::size_t before = 36; before <= 40; ++before) {
        const std::string start(before, 'a');
        EXPECT_EQ(in_quotes(start + letter + "b"), "'" + start + (before == 36 ? letter : "") + "...'") << before;
    }
    EXPECT_EQ(in_quotes(std::string(36, 'a') + letter), "'" + std::string(36, 'a') + letter + "'");
    EXPECT_EQ(in_quotes(std::string(50, '\x80')).size(), 42u) << "no letters at all";
}

TEST(Reason, SaysHowManyThereAre)
{
    EXPECT_EQ(but_there_are_only(4), ", but there are only 4, counted from 0");
}

}  // namespace
}  // namespace kerf::core
