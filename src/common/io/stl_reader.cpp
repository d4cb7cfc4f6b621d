#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/plain_text.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

constexpr std::size_t kHeaderBytes = 84;  ///< 80 of anything, and the number of triangles
constexpr std::size_t kTriangleBytes = 50;

bool is_word(std::string_view word, std::string_view lower_case)
{
    const auto is_same = [](char c, char lower) { return (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) == lower; };
    return word.size() == lower_case.size() && std::equal(word.begin(), word.end(), lower_case.begin(), is_same);
}

std::uint32_t binary_count(std::string_view bytes)
{
    return load<std::uint32_t>(bytes.data() + kHeaderBytes - 4, Endian::little);
}

bool has_exactly_its_triangles(std::string_view bytes)
{
    return bytes.size() >= kHeaderBytes &&
           bytes.size() - kHeaderBytes == std::uint64_t{binary_count(bytes)} * kTriangleBytes;
}

bool is_control(char c)
{
    return (c >= '\0' && c < ' ' && (c < '\t' || c > '\r')) || c == '\x7F';
}

/// The scanner with which a text is tested and read: without byte order mark and comments.
TextScanner scanner_of(const std::filesystem::path& path, std::string_view text)
{
    return {path, text, {.comment = ';', .continuations = false}};
}

/// The first word behind remarks, which are counted; empty if there is none.
std::string_view first_word(TextScanner& words, std::uint64_t& remarks)
{
    std::string_view word = words.word_of_any_line();
    for (; word.starts_with('#') || word.starts_with("//"); word = words.word_of_any_line()) {
        ++remarks;
        words.rest();
    }
    return word;
}

bool begins_like_text(const std::filesystem::path& path, std::string_view bytes)
{
    TextScanner words = scanner_of(path, bytes);
    std::uint64_t remarks = 0;
    const std::string_view word = first_word(words, remarks);
    return is_word(word.substr(0, 5), "solid") || is_word(word, "facet");
}

constexpr std::string_view kOuterLoop = "outerloop";  ///< without the blank that it should have

/// Whether "outer loop" stands in it, as in each facet of a text. O(n).
bool has_outer_loop(const std::filesystem::path& path, std::string_view bytes)
{
    TextScanner words = scanner_of(path, bytes);
    bool is_behind_outer = false;
    for (std::string_view word = words.word_of_any_line(); !word.empty(); word = words.word_of_any_line()) {
        if ((is_behind_outer && is_word(word, "loop")) || is_word(word, kOuterLoop)) return true;
        is_behind_outer = is_word(word, "outer");
    }
    return false;
}

/// Binary files may begin with anything, even "solid". But they have bytes that no text has: the number of triangles
/// ends with a 0 below 2^24. A text may have some of them in a name or a remark, but it has facets in words, which no
/// binary file has. Both are looked for as the text is read, so that this test is as lenient as the reader.
bool is_text(const std::filesystem::path& path, std::string_view bytes)
{
    const std::string_view beginning = bytes.substr(0, 1024);
    if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) return false;
    return std::none_of(beginning.begin(), beginning.end(), is_control) ||
           (begins_like_text(path, bytes) && has_outer_loop(path, bytes));
}

/// Facet normals are not read: they say nothing that the corners do not, and are often wrong.
TriangleSoup read_binary(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    if (bytes.size() < kHeaderBytes)
        fail(path, "it is neither a text nor a binary STL file, or its header is cut off; export it again");
    const std::uint64_t count = binary_count(bytes), room = (bytes.size() - kHeaderBytes) / kTriangleBytes;
    if (room < count)
        fail(path, std::string(begins_like_text(path, bytes)
                                   ? "it begins like text, but no facet follows, and as a binary file "
                                   : "") +
                       "it is truncated: its header promises " + std::to_string(count) +
                       " triangles, but there is room for " + std::to_string(room) + "; export it again");
    // Exporters that write as they go leave the count at 0 if they are stopped. Zeros, and less than a triangle, are
    // the padding of a block.
    if (room > count && bytes.substr(kHeaderBytes + count * kTriangleBytes).find_first_not_of('\0') != bytes.npos)
        fail(path, "its header promises " + std::to_string(count) + " triangles, but there are bytes for " +
                       std::to_string(room) + "; mend the number or export it again");
    notes.add(kBytesBehind, bytes.size() - kHeaderBytes - count * kTriangleBytes);
    SoupBuilder builder(path, notes);
    builder.soup.vertices.reserve(count * 3);
    builder.soup.triangles.reserve(count);
    const char* at = bytes.data() + kHeaderBytes;
    for (std::uint64_t i = 0; i < count; ++i, at += kTriangleBytes) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const char* xyz = at + 12 * (k + 1);
            const auto coordinate = [&](std::size_t axis) { return load<float>(xyz + 4 * axis, Endian::little); };
            corners[k] = builder.add_vertex({{coordinate(0), coordinate(1), coordinate(2)}, kNoNormal, {}});
        }
        builder.add_face(corners);
    }
    return builder.finish();
}

enum class Keyword : std::uint8_t
{
    none,  ///< no keyword
    end_of_file,
    solid,
    facet,
    outer,
    loop,
    vertex,
    endloop,
    endfacet,
    endsolid
};

constexpr std::array<std::pair<std::string_view, Keyword>, 8> kKeywords{{{"vertex", Keyword::vertex},
                                                                         {"facet", Keyword::facet},
                                                                         {"outer", Keyword::outer},
                                                                         {"loop", Keyword::loop},
                                                                         {"endloop", Keyword::endloop},
                                                                         {"endfacet", Keyword::endfacet},
                                                                         {"endsolid", Keyword::endsolid},
                                                                         {"solid", Keyword::solid}}};

/// Text: any number of "solid NAME facet normal x y z outer loop vertex x y z ... endloop endfacet ... endsolid NAME".
/// Other lines - colours, remarks - are passed over.
class TextStlReader
{
public:
    TextStlReader(const std::filesystem::path& path, std::string_view text, ReadingNotes& notes)
        : words_(scanner_of(path, text)), notes_(notes), builder_(path, notes)
    {
    }

    TriangleSoup read()
    {
        bool in_solid = false;
        for (Keyword keyword = first_keyword(); keyword != Keyword::end_of_file;) {
            switch (keyword) {
                case Keyword::facet:
                    outside_ += in_solid ? 0 : 1;
                    keyword = read_facet();
                    break;
                case Keyword::solid:
                case Keyword::endsolid:
                    unended_ += in_solid && keyword == Keyword::solid ? 1 : 0;
                    in_solid = keyword == Keyword::solid;
                    if (pass_name()) {
                        in_solid = true;
                        keyword = Keyword::facet;
                    } else {
                        keyword = next_keyword();
                    }
                    break;
                default:
                    words_.fail(in_quotes(word_) + " stands where a facet should begin; export it again");
            }
        }
        unended_ += in_solid ? 1 : 0;
        notes_.add("solids without an end read as far as they go", unended_);
        notes_.add("facets outside of solids read", outside_);
        notes_.add("keywords in two words read", divided_);
        notes_.add("'outerloop' in one word read", joined_);
        notes_.add("facets without 'endloop' or 'endfacet' read", unended_facets_);
        notes_.add("lines of no known kind passed over", unknown_);
        notes_.add(kLongLines, long_);
        return builder_.finish();
    }

private:
    /// A file must begin with a known keyword: anything else is another format.
    Keyword first_keyword()
    {
        word_ = first_word(words_, unknown_);
        const Keyword keyword = to_keyword(word_);
        if (keyword == Keyword::solid || keyword == Keyword::facet) return keyword;
        // The blank behind it may be missing.
        if (is_word(word_.substr(0, 5), "solid")) return Keyword::solid;
        words_.fail("it begins with " + in_quotes(word_) +
                    ", so it is neither a text nor a binary STL file; export it again or mend its extension");
    }

    Keyword to_keyword(std::string_view word)
    {
        if (word.empty()) return Keyword::end_of_file;
        if (is_word(word, kOuterLoop)) return Keyword::outer;
        for (const auto& [name, keyword] : kKeywords)
            if (is_word(word, name)) return keyword;
        if (!is_word(word, "end")) return Keyword::none;
        // In two words: end solid.
        TextScanner ahead = words_;
        const std::string whole = "end" + std::string(ahead.word());
        for (const auto& [name, keyword] : kKeywords)
            if (is_word(whole, name)) {
                words_.word();
                ++divided_;
                return keyword;
            }
        return Keyword::none;
    }

    /// Passes over lines that begin with no keyword, and over words behind a statement on its line.
    Keyword next_keyword()
    {
        for (;;) {
            const std::size_t line = words_.line();
            word_ = words_.word_of_any_line();
            const Keyword keyword = to_keyword(word_);
            if (keyword != Keyword::none) return keyword;
            ++(words_.line() == line ? long_ : unknown_);
            words_.rest();
        }
    }

    /// The rest of the line is the name of a solid; but all of the file may be one line. True if it goes on behind
    /// "facet normal".
    bool pass_name()
    {
        bool after_facet = false;
        for (std::string_view word = words_.word(); !word.empty(); word = words_.word()) {
            if (after_facet && is_word(word, "normal")) return true;
            after_facet = is_word(word, "facet");
        }
        return false;
    }

    /// Reads a facet and returns the keyword behind it.
    Keyword read_facet()
    {
        // "normal" and three numbers, whatever they are, and what else stands there.
        constexpr std::uint64_t kWords = 4;
        const std::size_t line = words_.line();
        std::uint64_t words = 0;
        for (;;) {
            word_ = words_.word_of_any_line();
            const Keyword keyword = to_keyword(word_);
            if (keyword == Keyword::outer) break;
            if (keyword != Keyword::none) fail_at("outer");
            if (++words == kWords + 1) ++(words_.line() == line ? long_ : unknown_);
        }
        if (is_word(word_, kOuterLoop))
            ++joined_;
        else if (next_keyword() != Keyword::loop)
            fail_at("loop");
        corners_.clear();
        Keyword keyword = next_keyword();
        for (; keyword == Keyword::vertex; keyword = next_keyword()) {
            Vertex v{{}, kNoNormal, {}};
            for (int axis = 0; axis < 3; ++axis)
                v.position[axis] = builder_.read_coordinate(words_, words_.word_of_any_line());
            corners_.push_back(builder_.add_vertex(v));
        }
        // If the end of a whole triangle is missing, the next keyword says the same.
        const bool ends_loop = keyword == Keyword::endloop;
        if (!ends_loop && (corners_.size() < 3 || !ends_facet(keyword)))
            fail_at(corners_.size() < 3 ? "vertex" : "endloop");
        builder_.add_face(corners_);
        if (ends_loop) keyword = next_keyword();
        if (!ends_facet(keyword)) fail_at("endfacet");
        unended_facets_ += ends_loop && keyword == Keyword::endfacet ? 0 : 1;
        return keyword == Keyword::endfacet ? next_keyword() : keyword;
    }

    static bool ends_facet(Keyword keyword)
    {
        return keyword == Keyword::endfacet || keyword == Keyword::facet || keyword == Keyword::endsolid;
    }

    [[noreturn]] void fail_at(const std::string& expected) const
    {
        if (word_.empty()) words_.fail("the file ends inside a facet; export it again");
        words_.fail(in_quotes(word_) + " stands where '" + expected + "' should be; export it again");
    }

    TextScanner words_;
    ReadingNotes& notes_;
    SoupBuilder builder_;
    std::string_view word_;  ///< of which a keyword was made
    std::vector<std::uint32_t> corners_;
    std::uint64_t unended_ = 0, outside_ = 0, divided_ = 0, joined_ = 0, unended_facets_ = 0, unknown_ = 0, long_ = 0;
};

}  // namespace

TriangleSoup read_stl(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    if (!has_exactly_its_triangles(bytes)) {
        ReadingNotes about_text = notes;
        const PlainText text(bytes, about_text);
        const std::string_view body = without_padding(text.view(), about_text);
        if (is_text(path, body)) {
            notes = about_text;
            const auto controls = std::count_if(body.begin(), body.end(), is_control);
            notes.add("control characters in the text passed over", static_cast<std::uint64_t>(controls));
            return TextStlReader(path, body, notes).read();
        }
    }
    return read_binary(path, bytes, notes);
}

}  // namespace kerf::core::io
