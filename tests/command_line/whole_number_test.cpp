#include "command_line/whole_number.h"

#include <gtest/gtest.h>

namespace kerf::command_line {
namespace {

/// What becomes of a text: the number as CLI11 reads it, or the sentence.
std::string read(std::string text, std::uint64_t least = 1, std::uint64_t most = 9)
{
    const CLI::Validator validator = whole_number(least, most);
    const std::string fault = validator(text);
    return fault.empty() ? text : fault;
}

TEST(WholeNumber, IsDecimal)
{
    EXPECT_EQ(read("7"), "7");
    EXPECT_EQ(read("+7"), "7");
    EXPECT_EQ(read("007"), "7") << "not octal";
}

TEST(WholeNumber, IsRefusedByOneSentence)
{
    for (const char* text : {"", "0", "10", "-1", "x", "1x", "1.5", "0x7", "++7", "+", " 7", "99999999999999999999"})
        EXPECT_EQ(read(text), "'" + std::string(text) + "' is no whole number from 1 to 9");
}

TEST(WholeNumber, MayBeAsLargeAsItsType)
{
    const std::string most = std::to_string(std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(read(most, 0, std::numeric_limits<std::uint64_t>::max()), most);
}

}  // namespace
}  // namespace kerf::command_line
