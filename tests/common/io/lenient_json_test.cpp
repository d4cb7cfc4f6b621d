#include "common/io/lenient_json.h"

#include <gtest/gtest.h>

#include <string>

namespace kerf::core::io {
namespace {

using nlohmann::json;

json parsed(const std::string& text)
{
    ReadingNotes notes;
    return parse_lenient_json(text, notes);
}

std::string notes_of(const std::string& text)
{
    ReadingNotes notes;
    parse_lenient_json(text, notes);
    return notes.describe();
}

TEST(LenientJson, StrictTextIsReadAsItIs)
{
    const std::string text = R"({"a": [1, -2.5e-3, true, null, "\t\u00e4\"]"], "b": {"": []}})";
    EXPECT_EQ(parsed(text), json::parse(text));
    EXPECT_EQ(notes_of(text), "");
}

TEST(LenientJson, ControlCharactersInTextsBecomeSpaces)
{
    EXPECT_EQ(parsed("{\"a\tb\": \"c\r\n\\\"\x01\"}"), json({{"a b", "c  \" "}}));
    EXPECT_EQ(notes_of("[\"\t\", \"\n\n\"]"), "3 control characters inside texts of the JSON taken as spaces");
}

TEST(LenientJson, BytesThatAreNotUtf8AreLatin1)
{
    EXPECT_EQ(parsed("[\"\xF6\xE4\"]"), json({"\xC3\xB6\xC3\xA4"}));
    // Valid letters of two, three and four bytes stay; overlong ones, surrogates and broken ones are letters each.
    const std::string valid = "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x8D\x8E";
    EXPECT_EQ(parsed("[\"" + valid + "\t\"]"), json({valid + " "}));
    EXPECT_EQ(notes_of("[\"\xC0\x80\"]"), "2 letters of the JSON that are not UTF-8 taken as Latin-1");
    EXPECT_EQ(notes_of("[\"\xED\xA0\x80\"]"), "3 letters of the JSON that are not UTF-8 taken as Latin-1");
    EXPECT_EQ(notes_of("[\"\xE2\x82\"]"), "2 letters of the JSON that are not UTF-8 taken as Latin-1");
}

TEST(LenientJson, NumbersThatAreNotFiniteBecomeEmptyTexts)
{
    for (const std::string number : {"NaN", "nan", "-nan", "-nan(ind)", "inf", "-Infinity", "+INF", "1.#INF", "-1.#IND",
                                     "1.#QNAN", "1e400", "-1E+400"}) {
        EXPECT_EQ(parsed("[1, " + number + ", \"NaN\"]"), json({1, "", "NaN"})) << number;
        EXPECT_EQ(notes_of("[" + number + "]"), "1 numbers of the JSON that are not finite passed over") << number;
    }
    EXPECT_EQ(notes_of("[1e-400, 1e300]"), "") << "too small is 0";
}

TEST(LenientJson, EverythingElseIsAFaultAtItsPlace)
{
    const auto place_of = [](const std::string& text) -> std::size_t {
        try {
            parsed(text);
        } catch (const JsonError& error) {
            return error.byte;
        }
        return 0;
    };
    EXPECT_EQ(place_of("[1, 2"), 6u);
    EXPECT_EQ(place_of("[1 2]"), 4u);
    EXPECT_EQ(place_of("[\"\xF6\xF6\t\", NaN, x]"), 14u) << "behind what was changed";
    EXPECT_NE(place_of("[\"a\\\n\"]"), 0u);
    EXPECT_NE(place_of("\"\\"), 0u);
    EXPECT_NE(place_of("nano"), 0u) << "a word is no number";
    EXPECT_NE(place_of(""), 0u);
}

}  // namespace
}  // namespace kerf::core::io
