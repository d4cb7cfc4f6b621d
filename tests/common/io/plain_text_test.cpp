#include "common/io/plain_text.h"

#include <cstdint>

#include "common/io/bytes.h"
#include "common/io/test_files.h"

namespace kerf::core::io {
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

std::u16string widened(const std::string& text)
{
    return {text.begin(), text.end()};
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

using TextOfFiles = MeshFileTest;

/// The same triangle as text of each format.
struct TextSample
{
    std::string name;
    std::string text;
};

const std::vector<TextSample>& triangles()
{
    static const std::vector<TextSample> samples{
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
         "face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.stl",
         "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
         "endsolid x\n"}};
    return samples;
}

void expect_triangle(const TriangleSoup& soup, const std::string& what)
{
    ASSERT_EQ(soup.triangles.size(), 1u) << what;
    EXPECT_EQ(soup.vertices[soup.triangles[0][1]].position, glm::vec3(1, 0, 0)) << what;
    EXPECT_EQ(soup.vertices[soup.triangles[0][2]].position, glm::vec3(0, 1, 0)) << what;
}

TEST_F(TextOfFiles, MayBeginWithAMarkAndBeUtf16InEveryFormat)
{
    for (const auto& [name, text] : triangles()) {
        const Read marked = read(name, "\xEF\xBB\xBF" + text);
        expect_triangle(marked.soup, name);
        EXPECT_EQ(marked.notes, "") << name;
        for (const Endian order : {Endian::little, Endian::big}) {
            const std::string bytes = utf16(widened(text), order);
            for (const std::size_t mark : {2, 0}) {
                const Read converted = read(name, bytes.substr(2 - mark));
                expect_triangle(converted.soup, name);
                EXPECT_EQ(converted.notes, "1 text in UTF-16 converted") << name << " " << mark;
            }
        }
    }
}

TEST_F(TextOfFiles, MayBeFilledUpAndNeedsNoLastLineEndInEveryFormat)
{
    for (const auto& [name, text] : triangles())
        for (const std::string& end : {std::string("\n"), std::string()}) {
            const std::string body = text.substr(0, text.size() - 1) + end;
            expect_triangle(read(name, body).soup, name);
            for (const std::string& padding : {std::string(1, '\0'), std::string(700, '\0'), std::string("\x1A")}) {
                const Read padded = read(name, body + padding);
                expect_triangle(padded.soup, name);
                EXPECT_EQ(padded.notes,
                          std::to_string(padding.size()) + " bytes that fill up the end of the file passed over")
                    << name;
            }
        }
}

TEST_F(TextOfFiles, SaysThatBinaryNumbersDoNotSurviveUtf16)
{
    std::string text = triangles()[2].text;
    text.replace(text.find("ascii"), 5, "binary_little_endian");
    EXPECT_TRUE(contains(error_of("a.ply", utf16(widened(text), Endian::little)), "UTF-16, which destroys binary"));
}

TEST_F(TextOfFiles, ExponentsMayBeFortrans)
{
    for (auto [name, text] : triangles()) {
        for (std::size_t at = 0; (at = text.find("1 0 0\n", at)) != std::string::npos; at += 10)
            text.replace(at, 1, "0.1D+01");
        expect_triangle(read(name, text).soup, name);
    }
}

TEST_F(TextOfFiles, CommasAreNoDecimalPoints)
{
    for (auto [name, text] : triangles()) {
        text.replace(text.rfind("1 0 0\n"), 1, "1,0");
        EXPECT_TRUE(contains(error_of(name, text),
                             "a coordinate is '1,0', which is not a number; write decimals with a "
                             "point, and blanks between numbers"))
            << name;
    }
}

TEST_F(TextOfFiles, AVertexOfNoFaceMayBeAnythingButFacesNeedNumbers)
{
    for (const char* bad : {"nan", "-inf", "1e40", "-1.#IND", "1.#INF00", "-nan(ind)", "nan(0x8000000)"})
        for (auto [name, text] : triangles()) {
            const std::size_t place = text.rfind("1 0 0\n");
            EXPECT_TRUE(contains(error_of(name, std::string(text).replace(place, 1, bad)),
                                 "a coordinate is '" + std::string(bad) + "', which is "))
                << name;
            if (name == "a.stl") continue;  // has no others
            const std::string line = name == "a.obj" ? "v " : "";
            if (name == "a.off") text.replace(text.find("3 1 0"), 1, "4");
            if (name == "a.ply") text.replace(text.find("vertex 3"), 8, "vertex 4");
            text.insert(text.rfind("0 1 0\n") + 6, line + std::string(bad) + " 2 2\n");
            const Read found = read(name, text);
            expect_triangle(found.soup, name);
            EXPECT_EQ(found.notes, "1 vertices of no face that are not finite numbers passed over")
                << name << " " << bad;
            for (const Vertex& v : found.soup.vertices) EXPECT_LE(v.position.x + v.position.y, 1.0f) << "no wider";
        }
}

}  // namespace
}  // namespace kerf::core::io
