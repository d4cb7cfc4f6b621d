#include <array>
#include <cctype>
#include <cstring>
#include <string>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/io/text_scanner.h"

namespace kerf::io {

namespace {

constexpr std::size_t kHeaderBytes = 84;  ///< 80 of anything, and the number of triangles
constexpr std::size_t kTriangleBytes = 50;

bool is_word(std::string_view word, std::string_view lower_case)
{
    if (word.size() != lower_case.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (std::tolower(static_cast<unsigned char>(word[i])) != lower_case[i]) return false;
    return true;
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

/// Binary files begin with anything, "solid" too: the size decides, and then whether a text could go on like this.
bool is_text(std::string_view bytes)
{
    if (has_exactly_its_triangles(bytes)) return false;
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || !is_word(bytes.substr(first, 5), "solid")) return false;
    return bytes.substr(0, 1024).find('\0') == std::string_view::npos;
}

/// Facet normals are not read: they say nothing that the corners do not, and are often wrong.
TriangleSoup read_binary(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    if (bytes.size() < kHeaderBytes)
        fail(path, "it is neither a text nor a binary STL file, or its header is cut off; export it again");
    const std::uint64_t count = binary_count(bytes), room = (bytes.size() - kHeaderBytes) / kTriangleBytes;
    if (room < count)
        fail(path, "it is truncated: its header promises " + std::to_string(count) +
                       " triangles, but there is room for " + std::to_string(room) + "; export it again");
    // Exporters that write as they go leave the count at 0 when they are stopped. Zeros, and less than a triangle, are
    // what fills up a block.
    if (room > count && bytes.substr(kHeaderBytes + count * kTriangleBytes).find_first_not_of('\0') != bytes.npos)
        fail(path, "its header promises " + std::to_string(count) + " triangles, but there are bytes for " +
                       std::to_string(room) + "; mend the number or export it again");
    SoupBuilder builder(path, notes);
    builder.soup.vertices.reserve(count * 3);
    builder.soup.triangles.reserve(count);
    const char* at = bytes.data() + kHeaderBytes;
    for (std::uint64_t i = 0; i < count; ++i, at += kTriangleBytes) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const char* xyz = at + 12 * (k + 1);
            const auto coordinate = [&](int axis) { return load<float>(xyz + 4 * axis, Endian::little); };
            corners[k] = builder.add_vertex({{coordinate(0), coordinate(1), coordinate(2)}, kNoNormal, {}});
        }
        builder.add_face(corners);
    }
    return builder.finish();
}

/// Text: any number of "solid NAME facet normal x y z outer loop vertex x y z ... endloop endfacet ... endsolid NAME".
class TextStlReader
{
public:
    TextStlReader(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
        : words_(path, bytes, TextScanner::Syntax{}), builder_(path, notes)
    {
    }

    TriangleSoup read()
    {
        for (;;) {
            const std::string_view word = words_.word_of_any_line();
            if (word.empty()) break;
            if (!is_word(word, "solid"))
                words_.fail(in_quotes(word) + " stands where a solid should begin; export it again");
            words_.rest();
            read_solid();
        }
        return builder_.finish();
    }

private:
    void read_solid()
    {
        for (;;) {
            const std::string_view word = words_.word_of_any_line();
            if (is_word(word, "endsolid")) {
                words_.rest();
                return;
            }
            if (word.empty()) words_.fail("the file ends inside a solid; export it again");
            if (!is_word(word, "facet"))
                words_.fail(in_quotes(word) + " stands where a facet should begin; export it again");
            read_facet();
        }
    }

    void read_facet()
    {
        expect("normal");
        for (int i = 0; i < 3; ++i) words_.word_of_any_line();
        expect("outer");
        expect("loop");
        corners_.clear();
        for (;;) {
            const std::string_view word = words_.word_of_any_line();
            if (is_word(word, "endloop")) break;
            if (word.empty()) words_.fail("the file ends inside a facet; export it again");
            if (!is_word(word, "vertex"))
                words_.fail(in_quotes(word) + " stands where a vertex should be; export it again");
            Vertex v{{}, kNoNormal, {}};
            for (int axis = 0; axis < 3; ++axis)
                v.position[axis] = words_.to_number(words_.word_of_any_line(), "a coordinate");
            corners_.push_back(builder_.add_vertex(v));
        }
        if (corners_.size() < 3) words_.fail("a facet has fewer than three vertices; give it three or take it out");
        builder_.add_face(corners_);
        expect("endfacet");
    }

    void expect(std::string_view keyword)
    {
        const std::string_view word = words_.word_of_any_line();
        if (word.empty()) words_.fail("the file ends where '" + std::string(keyword) + "' should be; export it again");
        if (!is_word(word, keyword))
            words_.fail(in_quotes(word) + " stands where '" + std::string(keyword) + "' should be; export it again");
    }

    TextScanner words_;
    SoupBuilder builder_;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

TriangleSoup read_stl(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    return is_text(bytes) ? TextStlReader(path, bytes, notes).read() : read_binary(path, bytes, notes);
}

}  // namespace kerf::io
