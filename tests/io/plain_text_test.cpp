#include "common/io/plain_text.h"

#include <cstdint>

#include "common/io/bytes.h"
#include "io/test_files.h"

namespace kerf::io {
namespace {

std::string utf16(const std::u16string& text, Endian order)
{
    std::string bytes;
    for (const char16_t unit : u"\uFEFF" + text) {
        const auto low = static_cast<char>(unit & 0xFF), high = static_cast<char>(unit >> 8);
        bytes += order == Endian::little ? low : high;
        bytes += order == Endian::little ? high : low;
    }
    return bytes;
}

TEST(PlainText, ConvertsEveryPlaneOfUtf16InBothOrders)
{
    for (const Endian order : {Endian::little, Endian::big}) {
        ReadingNotes notes;
        const PlainText text(utf16(u"v \u00E9\u20AC\U0001F600\n", order), notes);
        EXPECT_EQ(text.view(), "v \xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\n");
        EXPECT_TRUE(text.was_converted());
        EXPECT_EQ(notes.describe(), "1 text in UTF-16 converted");
    }
}

TEST(PlainText, PutsAMarkWhereHalfAPairOfSurrogatesIsMissing)
{
    ReadingNotes notes;
    std::u16string halves = u"abc";
    halves[0] = 0xDC00;
    halves[2] = 0xD800;
    EXPECT_EQ(PlainText(utf16(halves, Endian::little), notes).view(),
              "\xEF\xBF\xBD"
              "b"
              "\xEF\xBF\xBD");
    EXPECT_EQ(PlainText(utf16(u"ab", Endian::little) + "c", notes).view(), "ab") << "half a unit";
    EXPECT_EQ(PlainText("\xFF\xFE", notes).view(), "");
}

TEST(PlainText, IsAViewOfAnyOtherBytes)
{
    ReadingNotes notes;
    const std::string bytes("\xEF\xBB\xBFv\0\n", 6);
    const PlainText text(bytes, notes);
    EXPECT_EQ(text.view().data(), bytes.data());
    EXPECT_EQ(text.view().size(), bytes.size());
    EXPECT_TRUE(notes.none());
}

TEST(PlainText, EndsBeforeWhatFillsUpTheFile)
{
    ReadingNotes notes;
    EXPECT_EQ(without_padding(std::string_view("a\n\0\x1A\0", 5), notes), "a\n");
    EXPECT_EQ(without_padding("a\n", notes), "a\n");
    EXPECT_EQ(without_padding(std::string_view("\0", 1), notes), "");
    EXPECT_EQ(notes.describe(), "4 bytes that fill up the end of the file passed over");
}

}  // namespace
}  // namespace kerf::io
