#include "common/io/text_scanner.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/io/mesh_file.h"

namespace kerf::core::io {
namespace {

float number_of(const std::string& text)
{
    float value = 12345.0f;
    EXPECT_EQ(parse_float(text, value), NumberError::none) << text;
    return value;
}

NumberError error_of(const std::string& text)
{
    float value = 0.0f;
    return parse_float(text, value);
}

TEST(ParseFloat, RoundsCorrectlyWhereADoubleInBetweenWouldNot)
{
    // Just above the middle of two floats, by less than a double can tell: through a double it would round down to
    // even.
    EXPECT_EQ(number_of("1.000000059604644775390625000000000001"), std::nextafter(1.0f, 2.0f));
    EXPECT_EQ(number_of("1.000000059604644775390625"), 1.0f);
}

TEST(ParseFloat, TakesEveryWayToWriteANumber)
{
    EXPECT_EQ(number_of("+1.5"), 1.5f);
    EXPECT_EQ(number_of("-.5"), -0.5f);
    EXPECT_EQ(number_of("5."), 5.0f);
    EXPECT_EQ(number_of("1E+3"), 1000.0f);
    EXPECT_EQ(number_of("3.274081e-033"), 3.274081e-33f);
    EXPECT_EQ(number_of("1.5D+02"), 150.0f) << "Fortran";
    EXPECT_EQ(number_of("-1.5d-2"), -0.015f);
    EXPECT_TRUE(std::signbit(number_of("-0")));
}

TEST(ParseFloat, CallsZeroWhatIsTooSmall)
{
    EXPECT_EQ(number_of("1e-60"), 0.0f);
    EXPECT_EQ(number_of("1e-600"), 0.0f);
    EXPECT_EQ(number_of("0." + std::string(500, '0') + "1"), 0.0f);
}

TEST(ParseFloat, RefusesWhatIsTooLargeOrNotFinite)
{
    EXPECT_EQ(error_of("1e39"), NumberError::too_large);
    EXPECT_EQ(error_of("-1e600"), NumberError::too_large);
    EXPECT_EQ(error_of(std::string(500, '9')), NumberError::too_large);
    EXPECT_EQ(error_of("nan"), NumberError::not_finite);
    EXPECT_EQ(error_of("-inf"), NumberError::not_finite);
    EXPECT_EQ(error_of("-nan(ind)"), NumberError::not_finite);
    EXPECT_EQ(error_of("nan(0x800)"), NumberError::not_finite) << "has digits, but is not too large";
    for (const char* text : {"-1.#IND", "1.#INF", "1.#INF00", "1.#QNAN", "-1.#SNAN0"})
        EXPECT_EQ(error_of(text), NumberError::not_finite) << text;
}

TEST(ParseFloat, RefusesWhatIsNotANumber)
{
    for (const char* text : {"", "+", "-", ".", "e5", "1x", "1,5", "0x10", "1 ", "++1", "+-1", "1e", "d", "1d", "1d2d3",
                             "1.#X", ".#IND", "1#INF", "dead"})
        EXPECT_EQ(error_of(text), NumberError::not_a_number) << text;
}

RC_GTEST_PROP(ParseFloat, AgreesWithTheStandardLibrary, ())
{
    const auto bits = *rc::gen::arbitrary<std::uint32_t>();
    const float value = std::bit_cast<float>(bits);
    RC_PRE(std::isfinite(value));
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", *rc::gen::inRange(1, 20), static_cast<double>(value));
    const float expected = std::strtof(text, nullptr);
    RC_PRE(std::isfinite(expected));
    float read = 0.0f;
    RC_ASSERT(parse_float(text, read) == NumberError::none);
    RC_ASSERT(std::bit_cast<std::uint32_t>(read) == std::bit_cast<std::uint32_t>(expected));
}

const std::filesystem::path kPath = "file.txt";

TEST(TextScanner, EndsLinesAtLfCrLfAndCr)
{
    TextScanner scanner(kPath, "a 1\r\nb 2\rc 3\nd", {});
    for (const char* expected : {"a", "b", "c", "d"}) {
        ASSERT_TRUE(scanner.next_line());
        EXPECT_EQ(scanner.word(), expected);
    }
    EXPECT_FALSE(scanner.next_line());
    EXPECT_EQ(scanner.line(), 4u);
}

TEST(TextScanner, SkipsCommentsBlankLinesAndTheByteOrderMark)
{
    TextScanner scanner(kPath, "\xEF\xBB\xBF# nothing\n\n  \t\na#b\n", {.comment = '#', .continuations = false});
    ASSERT_TRUE(scanner.next_line());
    EXPECT_EQ(scanner.word(), "a");
    EXPECT_EQ(scanner.word(), "");
    EXPECT_FALSE(scanner.next_line());
}

TEST(TextScanner, JoinsLinesAfterABackslash)
{
    TextScanner scanner(kPath, "f 1 2 \\\r\n 3\\\n 4\ng\\", {.comment = '#', .continuations = true});
    ASSERT_TRUE(scanner.next_line());
    for (const char* expected : {"f", "1", "2", "3", "4", ""}) EXPECT_EQ(scanner.word(), expected);
    ASSERT_TRUE(scanner.next_line());
    EXPECT_EQ(scanner.word(), "g");
    EXPECT_EQ(scanner.line(), 4u);
}

TEST(TextScanner, TellsCommentsFromTheNumbersOfOldRuntimes)
{
    TextScanner scanner(kPath, "-1.#IND 1.#QNAN0 2.#comment\n3 #IND 4.", {.comment = '#', .continuations = false});
    ASSERT_TRUE(scanner.next_line());
    for (const char* expected : {"-1.#IND", "1.#QNAN0", "2.", ""}) EXPECT_EQ(scanner.word(), expected);
    ASSERT_TRUE(scanner.next_line());
    for (const char* expected : {"3", ""}) EXPECT_EQ(scanner.word(), expected);
}

TEST(TextScanner, TakesIntegersWithAPointAndNotesThem)
{
    ReadingNotes notes;
    const TextScanner scanner(kPath, "", {}, &notes);
    for (const auto& [text, value] : std::vector<std::pair<std::string, std::int64_t>>{
             {"8", 8}, {"-9223372036854775808", std::numeric_limits<std::int64_t>::min()}, {"+7", 7}})
        EXPECT_EQ(scanner.to_integer(text, "it"), value);
    EXPECT_TRUE(notes.none());
    for (const auto& [text, value] : std::vector<std::pair<std::string, std::int64_t>>{
             {"8.0", 8}, {"-0.0", 0}, {"1e3", 1000}, {"9007199254740992.0", 9007199254740992}})
        EXPECT_EQ(scanner.to_integer(text, "it"), value);
    EXPECT_EQ(notes.describe(), "4 integers written with a point or an exponent read");
    for (const char* text : {"8.5", "nan", "inf", "1e30", "9223372036854775808", "0x10", "8,0", ""})
        EXPECT_THROW(scanner.to_integer(text, "it"), FileError) << text;
}

TEST(TextScanner, FindsRecordsOnLinesOfTheirOwnOrOnFewer)
{
    const auto first_words = [](std::string_view text, std::uint64_t records) {
        TextScanner scanner(kPath, text, {.comment = '#', .continuations = false});
        std::string words;
        for (std::uint64_t left = records; left > 0; --left) {
            scanner.next_record(left);
            words += scanner.word_of_any_line();
            words += scanner.record_word();
        }
        return words + std::to_string(scanner.lines_passed_over());
    };
    EXPECT_EQ(first_words("a b\nc d\n", 2), "abcd0");
    EXPECT_EQ(first_words("a b x\n\n# y\nc d x x\ne f", 3), "abcdef2");
    EXPECT_EQ(first_words("a b c d\ne f", 3), "abcdef0");
    EXPECT_EQ(first_words("a b c d e f", 3), "abcdef0");
    EXPECT_EQ(first_words("", 1), "0");
}

TEST(TextScanner, CountsLinesOnceHoweverManyKindsOfRecordsThereAre)
{
    constexpr std::uint64_t kKinds = 1000;
    std::string text;
    for (std::uint64_t i = 0; i < kKinds; ++i) text += "1 2\n";
    TextScanner scanner(kPath, text, {});
    for (std::uint64_t left = kKinds; left > 0; --left) {
        scanner.new_records();
        scanner.next_record(left);
        EXPECT_EQ(scanner.word_of_record_lines(), "1");
    }
    scanner.end_records();
    EXPECT_EQ(scanner.lines_passed_over(), kKinds);
    EXPECT_LE(scanner.lines_counted(), kKinds);
}

TEST(TextScanner, NamesFileAndLineInErrors)
{
    TextScanner scanner(kPath, "a\n\nb x\n", {});
    scanner.next_line();
    scanner.next_line();
    scanner.word();
    try {
        scanner.to_float(scanner.word(), "a coordinate");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(), "file.txt: line 3: a coordinate is 'x', which is not a number; write one");
    }
}

}  // namespace
}  // namespace kerf::core::io
