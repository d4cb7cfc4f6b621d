#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "common/io/plain_text.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

/// Reads OFF as Geomview describes it: [ST][C][N]OFF, the counts of vertices, faces and edges, then
///   vertex: x y z [normal] [r g b [a]] [s t]        face: n i1 ... in [colour]
/// Each vertex and each face begins on a line of its own; the rest of the line is ignored. If there are fewer lines
/// than that, they follow one another, and colours have four numbers. The letters may come in any order and case; a
/// program that writes N before C (vcglib) writes colours before normals.
class OffReader
{
public:
    OffReader(const std::filesystem::path& path, std::string_view text, ReadingNotes& notes)
        : notes_(notes), line_(path, text, {.comment = '#', .continuations = false}, &notes), builder_(path, notes)
    {
    }

    TriangleSoup read()
    {
        read_header();
        for (std::uint64_t i = 0; i < vertex_count_; ++i) read_vertex(i);
        line_.next_record(face_count_);
        // The numbers behind faces are their colours.
        notes_.add(kLongLines, line_.lines_passed_over());
        line_.new_records();
        for (std::uint64_t i = 0; i < face_count_; ++i) read_face(i);
        line_.end_records();
        add_colours();
        notes_.add("vertices without the numbers that the keyword promises completed", incomplete_);
        return builder_.finish();
    }

private:
    void read_header()
    {
        if (!line_.next_line()) line_.fail("there is nothing in it but blanks and comments; export it again");
        std::string_view word = line_.word();
        // The keyword may be left out.
        if (std::isdigit(to_unsigned(word.front())) == 0 || lower_case(word).find("off") != std::string::npos) {
            word = read_keyword(word);
            if (word.empty() && line_.next_line()) word = line_.word();
        }
        if (lower_case(word) == "binary") line_.fail("binary OFF is not supported; export it as text or as ply");
        vertex_count_ = to_count(word, "the number of vertices");
        const std::size_t first_line = line_.line();
        face_count_ = to_count(line_.word_of_any_line(), "the number of faces");
        // The number of edges may be missing; nobody needs it. If each count has a line of its own, so has this one.
        if (line_.line() == first_line)
            line_.word();
        else if (has_line_of_its_own())
            line_.word_of_any_line();

        // Each number but the last takes two bytes, with its separator.
        const std::uint64_t room = (line_.bytes_left() + 1) / 2;
        if (vertex_count_ > room / 3 || face_count_ > room)
            line_.fail(std::to_string(vertex_count_) + " vertices and " + std::to_string(face_count_) +
                       " faces are more than the file has room for; mend the counts or export it again");
        builder_.soup.vertices.reserve(vertex_count_);
        builder_.soup.triangles.reserve(std::min(face_count_, room / 4));
    }

    /// Whether the next word is the only one of a later line.
    bool has_line_of_its_own() const
    {
        TextScanner ahead = line_;
        return ahead.word().empty() && !ahead.word_of_any_line().empty() && ahead.word().empty();
    }

    static std::string lower_case(std::string_view word)
    {
        std::string lower(word);
        for (char& c : lower) c = static_cast<char>(std::tolower(to_unsigned(c)));
        return lower;
    }

    /// Returns the first word behind the keyword on its line. Some files (ModelNet's) leave out the blank: OFF8 6 12.
    std::string_view read_keyword(std::string_view word)
    {
        const std::string lower = lower_case(word);
        const std::size_t off = std::min(lower.find("off"), lower.size());
        const std::string_view letters = std::string_view(lower).substr(0, off);
        const std::string_view behind = word.substr(std::min(off + 3, word.size()));
        const bool is_off = off < lower.size() && (behind.empty() || std::isdigit(to_unsigned(behind[0])) != 0);
        // 4 means four coordinates, n as many as a number says: only 3 is read. nOFF is not NOFF.
        const bool has_dimension = is_off && word.substr(0, off + 3).ends_with("nOFF");
        const std::string_view known = letters.substr(0, letters.size() - (has_dimension ? 1 : 0));
        if (is_off && (known.ends_with("4") || known.ends_with("4n"))) fail_of_dimension(word);
        if (!is_off || !read_letters(known))
            line_.fail("it begins with " + in_quotes(word) + " instead of OFF; export it again or mend its extension");
        std::string_view next = behind.empty() ? line_.word() : behind;
        if (!has_dimension) return next;
        if (next.empty() && line_.next_line()) next = line_.word();
        if (to_count(next, "the number of dimensions") != 3) fail_of_dimension(word);
        return line_.word();
    }

    [[noreturn]] void fail_of_dimension(std::string_view keyword) const
    {
        line_.fail(in_quotes(keyword) + " has coordinates that are not three-dimensional; export it as OFF");
    }

    static unsigned char to_unsigned(char c) { return static_cast<unsigned char>(c); }

    /// ST, C and N, each once at most.
    bool read_letters(std::string_view letters)
    {
        while (!letters.empty()) {
            bool& has = letters[0] == 's' ? has_uv_ : (letters[0] == 'c' ? has_colour_ : has_normal_);
            if (has || !(letters.starts_with("st") || letters[0] == 'c' || letters[0] == 'n')) return false;
            if (letters[0] == 'c') is_colour_first_ = has_normal_;
            letters.remove_prefix(letters[0] == 's' ? 2 : 1);
            has = true;
        }
        return true;
    }

    std::uint64_t to_count(std::string_view word, std::string_view what)
    {
        const std::int64_t count = line_.to_integer(word, what);
        if (count < 0) line_.fail(std::string(what) + " is negative; mend it or export the file again");
        return static_cast<std::uint64_t>(count);
    }

    /// The first word of the next of `left` records; empty at the end of the file.
    std::string_view begin_record(std::uint64_t left)
    {
        line_.next_record(left);
        return line_.word_of_any_line();
    }

    void read_vertex(std::uint64_t i)
    {
        std::string_view word = begin_record(vertex_count_ - i + face_count_);
        if (word.empty())
            line_.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(vertex_count_) +
                       " vertices; export it again");
        Vertex v{{}, kNoNormal, {}};
        for (int axis = 0; axis < 3; ++axis) {
            if (axis > 0) word = line_.record_word();
            v.position[axis] = builder_.read_coordinate(line_, word);
        }
        if (has_normal_ || has_colour_ || has_uv_) read_attributes(v);
        builder_.add_vertex(v);
    }

    /// A colour has three or four numbers: the length of the line decides.
    void read_attributes(Vertex& v)
    {
        constexpr std::size_t kMost = 9;
        const std::size_t normal = has_normal_ ? 3 : 0, uv = has_uv_ ? 2 : 0, least = normal + uv;
        const std::size_t most = least + (has_colour_ ? 4 : 0);
        std::array<std::string_view, kMost> words;
        std::size_t count = 0;
        while (count < most) {
            words[count] = line_.record_word();
            if (words[count].empty()) break;
            ++count;
        }
        const std::size_t channels = count >= least + 3 ? count - least : 0;
        if (count < least || (has_colour_ && channels == 0)) ++incomplete_;
        const std::size_t normal_at = is_colour_first_ ? channels : 0, colour_at = is_colour_first_ ? 0 : normal;
        const auto number = [&](std::size_t k) { return TextScanner::to_attribute(words[k]); };
        if (has_normal_ && normal_at + 3 <= count)
            v.normal = {number(normal_at), number(normal_at + 1), number(normal_at + 2)};
        if (has_uv_ && count >= least) v.uv = {number(normal + channels), number(normal + channels + 1)};
        if (!has_colour_) return;
        // No decimal point: 0 to 255.
        bool whole = true;
        for (std::size_t i = 0; i < std::min<std::size_t>(channels, 3); ++i)
            whole = whole && words[colour_at + i].find_first_of(".eE") == std::string_view::npos;
        for (std::size_t i = 0; i < 4; ++i)
            colours_.push_back(i >= channels ? 1.0f : number(colour_at + i) / (whole ? 255.0f : 1.0f));
    }

    void read_face(std::uint64_t i)
    {
        const std::string_view first = begin_record(face_count_ - i);
        if (first.empty())
            line_.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(face_count_) +
                       " faces; export it again");
        const std::uint64_t count = to_count(first, "the number of corners");
        if (count > (line_.bytes_left() + 1) / 2)
            line_.fail("a face with " + std::to_string(count) +
                       " corners is more than the file has room for; mend the count or export it again");
        face_.clear();
        for (std::uint64_t k = 0; k < count; ++k) {
            // The number of corners may have a line of its own.
            const std::string_view word = k == 0 ? line_.word_of_any_line() : line_.record_word();
            const std::int64_t index = line_.to_integer(word, "a vertex index");
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

    ReadingNotes& notes_;
    TextScanner line_;
    SoupBuilder builder_;
    bool has_uv_ = false, has_colour_ = false, has_normal_ = false, is_colour_first_ = false;
    std::uint64_t vertex_count_ = 0, face_count_ = 0, incomplete_ = 0;
    Buffer<float> colours_;
    std::vector<std::uint32_t> face_;
};

}  // namespace

TriangleSoup read_off(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    const PlainText text(bytes, notes);
    return OffReader(path, without_padding(text.view(), notes), notes).read();
}

}  // namespace kerf::core::io
