#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/io/text_scanner.h"

namespace kerf::io {

namespace {

/// Reads OFF as Geomview describes it: [ST][C][N]OFF, the counts of vertices, faces and edges, then
///   vertex: x y z [normal] [r g b [a]] [s t]        face: n i1 ... in [colour]
/// Each vertex and each face begins on a line of its own; what is behind it on the line is not looked at.
class OffReader
{
public:
    OffReader(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
        : line_(path, bytes, {.comment = '#', .continuations = false}), builder_(path, notes)
    {
    }

    TriangleSoup read()
    {
        read_header();
        for (std::uint64_t i = 0; i < vertex_count_; ++i) read_vertex(i);
        for (std::uint64_t i = 0; i < face_count_; ++i) read_face(i);
        add_colours();
        return builder_.finish();
    }

private:
    void read_header()
    {
        if (!line_.next_line()) line_.fail("there is nothing but comments; export it again");
        std::string_view word = line_.word();
        // The keyword may be left out.
        if (const bool has_keyword = std::isalpha(static_cast<unsigned char>(word.front())) != 0 || word == "4OFF";
            has_keyword) {
            word = read_keyword(word);
            if (word.empty() && line_.next_line()) word = line_.word();
        }
        if (word == "BINARY") line_.fail("binary OFF is not supported; export it as text or as ply");
        vertex_count_ = to_count(word, "the number of vertices");
        face_count_ = to_count(line_.word_of_any_line(), "the number of faces");
        // The number of edges may be missing; nobody needs it.

        // A number takes two bytes with its separator, but the last.
        const std::uint64_t room = (line_.bytes_left() + 1) / 2;
        if (vertex_count_ > room / 3 || face_count_ > room)
            line_.fail(std::to_string(vertex_count_) + " vertices and " + std::to_string(face_count_) +
                       " faces are more than the file has room for; mend the counts or export it again");
        builder_.soup.vertices.reserve(vertex_count_);
        builder_.soup.triangles.reserve(std::min(face_count_, room / 4));
    }

    /// Returns the first word behind the keyword on its line. Some files (ModelNet's) leave out the blank: OFF8 6 12.
    std::string_view read_keyword(std::string_view word)
    {
        const std::string whole(word);
        if (word.starts_with("ST")) {
            has_uv_ = true;
            word.remove_prefix(2);
        }
        if (word.starts_with("C")) {
            has_colour_ = true;
            word.remove_prefix(1);
        }
        if (word.starts_with("N")) {
            has_normal_ = true;
            word.remove_prefix(1);
        }
        if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
            line_.fail(in_quotes(whole) + " has coordinates that are not three-dimensional; export it as OFF");
        if (word.starts_with("OFF") && word.size() > 3 && std::isdigit(static_cast<unsigned char>(word[3])) != 0)
            return word.substr(3);
        if (word != "OFF")
            line_.fail("it begins with " + in_quotes(whole) + " instead of OFF; export it again or mend its extension");
        return line_.word();
    }

    std::uint64_t to_count(std::string_view word, std::string_view what)
    {
        const std::int64_t count = line_.to_integer(word, what);
        if (count < 0) line_.fail(std::string(what) + " is negative; mend it or export the file again");
        return static_cast<std::uint64_t>(count);
    }

    void read_vertex(std::uint64_t i)
    {
        if (!line_.next_line())
            line_.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(vertex_count_) +
                       " vertices; export it again");
        Vertex v{{}, kNoNormal, {}};
        for (int axis = 0; axis < 3; ++axis) v.position[axis] = line_.number("a coordinate");
        if (has_normal_)
            for (int axis = 0; axis < 3; ++axis) v.normal[axis] = line_.number("a normal");
        if (has_colour_ || has_uv_) read_colour_and_uv(v);
        builder_.add_vertex(v);
    }

    /// A colour has three or four numbers: the length of the line decides.
    void read_colour_and_uv(Vertex& v)
    {
        std::array<float, 6> numbers{};
        std::size_t count = 0;
        bool whole = true;  // no decimal point: 0 to 255
        for (std::string_view word = line_.word(); !word.empty() && count < numbers.size(); word = line_.word()) {
            numbers[count] = line_.to_number(word, "a colour or texture coordinate");
            if (count < 3) whole = whole && word.find_first_of(".eE") == std::string_view::npos;
            ++count;
        }
        const std::size_t uv = has_uv_ ? 2 : 0;
        const std::size_t channels = count - std::min(count, uv);
        if (count < uv || (has_colour_ ? channels != 3 && channels != 4 : channels != 0))
            line_.fail("a vertex has " + std::to_string(count) +
                       " numbers for colour and texture; mend it or leave them out");
        if (has_uv_) v.uv = {numbers[channels], numbers[channels + 1]};
        if (!has_colour_) return;
        for (std::size_t i = 0; i < 4; ++i)
            colours_.push_back(i >= channels ? 1.0f : (whole ? numbers[i] / 255.0f : numbers[i]));
    }

    void read_face(std::uint64_t i)
    {
        if (!line_.next_line())
            line_.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(face_count_) +
                       " faces; export it again");
        const std::uint64_t count = to_count(line_.word(), "the number of corners");
        if (count > (line_.bytes_left() + 1) / 2)
            line_.fail("a face with " + std::to_string(count) +
                       " corners is more than the file has room for; mend the count or export it again");
        face_.clear();
        for (std::uint64_t k = 0; k < count; ++k) {
            const std::int64_t index = line_.integer("a vertex index");
            if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count_)
                line_.fail("vertex " + std::to_string(index) + " is out of range: there are " +
                           std::to_string(vertex_count_) + ", counted from 0; mend the face or take it out");
            face_.push_back(static_cast<std::uint32_t>(index));
        }
        builder_.add_face(face_);
    }

    void add_colours()
    {
        if (!has_colour_) return;
        builder_.soup.streams.push_back({"color", 4, std::move(colours_)});
    }

    TextScanner line_;
    SoupBuilder builder_;
    bool has_uv_ = false, has_colour_ = false, has_normal_ = false;
    std::uint64_t vertex_count_ = 0, face_count_ = 0;
    Buffer<float> colours_;
    std::vector<std::uint32_t> face_;
};

}  // namespace

TriangleSoup read_off(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    return OffReader(path, bytes, notes).read();
}

}  // namespace kerf::io
