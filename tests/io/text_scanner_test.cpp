#include "common/io/text_scanner.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <string>

#include "common/io/mesh_file.h"

namespace kerf::io {
namespace {

float parsed(const std::string& text)
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
    EXPECT_EQ(parsed("1.000000059604644775390625000000000001"), std::nextafter(1.0f, 2.0f));
    EXPECT_EQ(parsed("1.000000059604644775390625"), 1.0f);
}

TEST(ParseFloat, TakesEveryWayToWriteANumber)
{
    EXPECT_EQ(parsed("+1.5"), 1.5f);
    EXPECT_EQ(parsed("-.5"), -0.5f);
    EXPECT_EQ(parsed("5."), 5.0f);
    EXPECT_EQ(parsed("1E+3"), 1000.0f);
    EXPECT_EQ(parsed("3.274081e-033"), 3.274081e-33f);
    EXPECT_TRUE(std::signbit(parsed("-0")));
}

TEST(ParseFloat, CallsZeroWhatIsTooSmall)
{
    EXPECT_EQ(parsed("1e-60"), 0.0f);
    EXPECT_EQ(parsed("1e-600"), 0.0f);
    EXPECT_EQ(parsed("0." + std::string(500, '0') + "1"), 0.0f);
}

TEST(ParseFloat, RefusesWhatIsTooLargeOrNotFinite)
{
    EXPECT_EQ(error_of("1e39"), NumberError::too_large);
    EXPECT_EQ(error_of("-1e600"), NumberError::too_large);
    EXPECT_EQ(error_of(std::string(500, '9')), NumberError::too_large);
    EXPECT_EQ(error_of("nan"), NumberError::not_finite);
    EXPECT_EQ(error_of("-inf"), NumberError::not_finite);
}

TEST(ParseFloat, RefusesWhatIsNotANumber)
{
    for (const char* text : {"", "+", "-", ".", "e5", "1x", "1,5", "0x10", "1 ", "++1", "+-1", "1e"})
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
    TextScanner scanner(kPath, "f 1 2 \\\r\n 3\\\n 4\ng", {.comment = '#', .continuations = true});
    ASSERT_TRUE(scanner.next_line());
    for (const char* expected : {"f", "1", "2", "3", "4", ""}) EXPECT_EQ(scanner.word(), expected);
    ASSERT_TRUE(scanner.next_line());
    EXPECT_EQ(scanner.word(), "g");
    EXPECT_EQ(scanner.line(), 4u);
}

TEST(TextScanner, NamesFileAndLineInErrors)
{
    TextScanner scanner(kPath, "a\n\nb x\n", {});
    scanner.next_line();
    scanner.next_line();
    scanner.word();
    try {
        scanner.number("a coordinate");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(), "file.txt: line 3: a coordinate is 'x', which is not a number; write one");
    }
}

}  // namespace
}  // namespace kerf::io
