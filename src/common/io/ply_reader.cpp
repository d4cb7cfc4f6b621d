#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/mesh_file.h"
#include "common/io/plain_text.h"
#include "common/io/ply_header.h"
#include "common/io/ply_names.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

/// Numbers of an ASCII file, one word each. Elements begin on lines of their own, or follow one another on fewer lines.
class TextSource
{
public:
    /// @param body  what follows the header
    TextSource(const std::filesystem::path& path, std::string_view body, const PlyHeader& header, ReadingNotes& notes)
        : words_(path, body, TextScanner::Syntax{}, &notes)
    {
        words_.set_line(header.lines + 1);
    }

    /// Elements follow one another whatever lines there are.
    void take_elements_in_order() { words_.take_records_in_order(); }

    /// Whether lines were too short and others too long: numbers that one lacked may be those of another.
    bool is_doubtful() const { return short_lines_ > 0 && words_.lines_passed_over() > 0; }

    void begin_elements() { words_.new_records(); }
    void begin_element(std::uint64_t left) { words_.next_record(left); }

    // Whatever the type: the float nearest to the decimal number, not to the double nearest to it.
    float coordinate(PlyType, SoupBuilder& builder)
    {
        return builder.read_coordinate(words_, words_.word_of_record_lines());
    }
    /// A number that does not matter for the surface: NaN if it is none, or if a line that is one element ends before.
    float attribute(PlyType)
    {
        const std::string_view word = words_.word_of_record_lines();
        if (word.empty()) expect_line_end();
        return TextScanner::to_attribute(word);
    }
    std::int64_t integer(PlyType, std::string_view what)
    {
        return words_.to_integer(words_.word_of_record_lines(), what);
    }
    /// The length of a list that does not matter for the surface.
    std::int64_t length_to_skip(PlyType, std::string_view what)
    {
        const std::string_view word = words_.word_of_record_lines();
        if (!word.empty()) return words_.to_integer(word, what);
        expect_line_end();
        return 0;
    }
    void skip(PlyType, std::uint64_t count)
    {
        for (std::uint64_t i = 0; i < count; ++i)
            if (words_.word_of_record_lines().empty()) return expect_line_end();
    }
    void finish(ReadingNotes& notes)
    {
        words_.end_records();
        notes.add(kLongLines, words_.lines_passed_over());
        notes.add("lines with fewer numbers than the header promises read without them", short_lines_);
    }
    [[noreturn]] void fail(const std::string& reason) const { words_.fail(reason); }

private:
    /// There is no further word. Only a line that is one element may end before it is complete.
    void expect_line_end()
    {
        if (!words_.records_have_lines()) fail("a number is missing; export it again");
        if (std::exchange(short_line_, words_.line()) != words_.line()) ++short_lines_;
    }

    TextScanner words_;
    std::size_t short_line_ = 0;  ///< the latest
    std::uint64_t short_lines_ = 0;
};

/// Numbers of a binary file of either byte order.
class BinarySource
{
public:
    BinarySource(const std::filesystem::path& path, std::string_view bytes, const PlyHeader& header)
        : path_(path),
          bytes_(bytes),
          at_(header.size),
          order_(header.format == PlyFormat::big_endian ? Endian::big : Endian::little)
    {
    }

    void begin_elements() {}
    void begin_element(std::uint64_t) {}

    float coordinate(PlyType type, SoupBuilder&) { return attribute(type); }

    float attribute(PlyType type)
    {
        switch (type) {
            case PlyType::float32:
                return load<float>(take(4), order_);
            case PlyType::float64:
                return static_cast<float>(load<double>(take(8), order_));
            case PlyType::uint64:
                return static_cast<float>(load<std::uint64_t>(take(8), order_));
            default:
                return static_cast<float>(integer(type, "a number"));
        }
    }

    std::int64_t integer(PlyType type, std::string_view what)
    {
        switch (type) {
            case PlyType::int8:
                return load<std::int8_t>(take(1), order_);
            case PlyType::uint8:
                return load<std::uint8_t>(take(1), order_);
            case PlyType::int16:
                return load<std::int16_t>(take(2), order_);
            case PlyType::uint16:
                return load<std::uint16_t>(take(2), order_);
            case PlyType::int32:
                return load<std::int32_t>(take(4), order_);
            case PlyType::uint32:
                return load<std::uint32_t>(take(4), order_);
            case PlyType::int64:
                return load<std::int64_t>(take(8), order_);
            case PlyType::uint64:
                // A number beyond the largest is no index and no length either.
                return static_cast<std::int64_t>(std::min(load<std::uint64_t>(take(8), order_),
                                                          std::uint64_t{std::numeric_limits<std::int64_t>::max()}));
            case PlyType::float32:
                return whole(load<float>(take(4), order_), what);
            case PlyType::float64:
                return whole(load<double>(take(8), order_), what);
        }
        return 0;
    }

    std::int64_t length_to_skip(PlyType type, std::string_view what) { return integer(type, what); }

    void skip(PlyType type, std::uint64_t count)
    {
        if (count > (bytes_.size() - at_) / size_of(type)) fail("it is truncated; export it again");
        at_ += static_cast<std::size_t>(count) * size_of(type);
    }

    void finish(ReadingNotes& notes)
    {
        notes.add("integers stored as floating point read", floats_);
        notes.add(kBytesBehind, bytes_.size() - at_);
    }

    [[noreturn]] void fail(const std::string& reason) const
    {
        io::fail(path_, reason + " (at byte " + std::to_string(at_) + " of " + std::to_string(bytes_.size()) + ")");
    }

private:
    std::int64_t whole(double value, std::string_view what)
    {
        // Up to here doubles are whole numbers without gaps.
        constexpr double kLargest = 9007199254740992.0;
        if (!(std::abs(value) <= kLargest) || std::trunc(value) != value)
            fail(std::string(what) + " is not a whole number; export it again");
        ++floats_;
        return static_cast<std::int64_t>(value);
    }

    const char* take(std::size_t size)
    {
        if (bytes_.size() - at_ < size) fail("it is truncated; export it again");
        const char* place = bytes_.data() + at_;
        at_ += size;
        return place;
    }

    const std::filesystem::path& path_;
    std::string_view bytes_;
    std::size_t at_;
    Endian order_;
    std::uint64_t floats_ = 0;
};

template <class Source>
class PlyReader
{
public:
    PlyReader(const std::filesystem::path& path, const PlyHeader& header, Source source, ReadingNotes& notes)
        : path_(path), header_(header), source_(std::move(source)), notes_(notes), builder_(path, notes)
    {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") vertex_count_ += element.count;
            if (!element.properties.empty()) elements_left_ += element.count;
        }
    }

    TriangleSoup read()
    {
        bool has_vertices = false;
        for (const PlyElement& element : header_.elements) {
            source_.begin_elements();
            if (element.name == "vertex") {
                if (std::exchange(has_vertices, true)) fail(path_, "it has more than one element 'vertex'; join them");
                read_vertices(element);
            } else if (element.name == "face") {
                read_faces(element);
            } else if (element.name == "tristrips") {
                read_strips(element);
            } else {
                skip(element);
            }
        }
        source_.finish(notes_);
        if (face_sizes_.empty()) check_list_names();
        // Faces may come before their vertices.
        for (std::size_t i = 0, first = 0; i < face_sizes_.size(); first += face_sizes_[i], ++i)
            builder_.add_face(std::span(corners_).subspan(first, face_sizes_[i]));
        return builder_.finish();
    }

    const Source& source() const { return source_; }

private:
    void read_vertices(const PlyElement& element)
    {
        const PlyVertexLayout layout = ply_vertex_layout(element);
        if (std::any_of(element.properties.begin(), element.properties.end(), lists_vertices))
            fail(path_,
                 "its header has the corners of faces among the properties of vertices; write a line 'element face "
                 "COUNT' before them, or export it again");
        if (!layout.has_position) fail(path_, "its vertices have no x, y and z; name their coordinates so");
        for (const char* name : {"x", "y", "z"})
            if (std::count_if(element.properties.begin(), element.properties.end(),
                              [&](const PlyProperty& p) { return p.name == name; }) > 1)
                fail(path_, "its vertices have more than one property '" + std::string(name) + "'; take one out");
        builder_.soup.vertices.reserve(element.count);
        for (const PlyStream& stream : layout.streams) {
            builder_.soup.streams.push_back({stream.name, stream.width, {}});
            builder_.soup.streams.back().values.resize(element.count * stream.width);
        }
        std::vector<VertexStream>& streams = builder_.soup.streams;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            source_.begin_element(elements_left_--);
            // As floats: position, normal, uv.
            std::array<float, 8> core{};
            for (std::size_t k = 0; k < element.properties.size(); ++k) {
                const PlyProperty& property = element.properties[k];
                const PlyDestination& to = layout.destinations[k];
                if (property.is_list) {
                    skip_list(property);
                    continue;
                }
                const bool is_core = to.stream == PlyDestination::kCore;
                const float value = is_core && to.component < 3 ? source_.coordinate(property.type, builder_)
                                                                : source_.attribute(property.type);
                if (is_core)
                    core[to.component] = value;
                else
                    streams[to.stream].values[i * streams[to.stream].width + to.component] = value / to.one;
            }
            builder_.add_vertex({{core[0], core[1], core[2]}, {core[3], core[4], core[5]}, {core[6], core[7]}});
        }
    }

    void read_faces(const PlyElement& element)
    {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            source_.begin_element(elements_left_--);
            for (const PlyProperty& property : element.properties) {
                if (lists_vertices(property)) {
                    const std::size_t first = corners_.size();
                    read_indices(property, 0);
                    face_sizes_.push_back(corners_.size() - first);
                } else {
                    skip(property);
                }
            }
        }
    }

    /// Two names by the description, which uses both, and one that some programs write.
    static bool lists_vertices(const PlyProperty& property)
    {
        return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index" ||
                                    property.name == "vertex_indexes");
    }

    /// Strips of triangles, several in a list, separated by -1; every other triangle is turned over.
    void read_strips(const PlyElement& element)
    {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            source_.begin_element(elements_left_--);
            for (const PlyProperty& property : element.properties) {
                if (!lists_vertices(property)) {
                    skip(property);
                    continue;
                }
                const std::size_t first = corners_.size();
                read_indices(property, -1);
                const std::vector<std::uint32_t> strip(corners_.begin() + static_cast<std::ptrdiff_t>(first),
                                                       corners_.end());
                corners_.resize(first);
                add_strips(strip);
            }
        }
    }

    void add_strips(const std::vector<std::uint32_t>& strip)
    {
        for (std::size_t k = 0, begin = 0; k < strip.size(); ++k) {
            if (strip[k] == kRestart) begin = k + 1;
            if (strip[k] == kRestart || k < begin + 2) continue;
            const bool odd = (k - begin) % 2 != 0;
            for (const std::size_t corner : {k - (odd ? 1 : 2), k - (odd ? 2 : 1), k})
                corners_.push_back(strip[corner]);
            face_sizes_.push_back(3);
        }
    }

    /// Appends a list of indices to `corners_`; negative ones, down to `least`, become kRestart.
    void read_indices(const PlyProperty& property, std::int64_t least)
    {
        const std::int64_t count = source_.integer(property.count_type, kLength);
        if (count < 0) source_.fail("a list of indices has a negative length; export it again");
        for (std::int64_t k = 0; k < count; ++k) {
            const std::int64_t index = source_.integer(property.type, "a vertex index");
            if (index < least || (index >= 0 && static_cast<std::uint64_t>(index) >= vertex_count_))
                source_.fail("vertex " + std::to_string(index) + " is out of range: there are " +
                             std::to_string(vertex_count_) + ", counted from 0; mend the face or take it out");
            corners_.push_back(index < 0 ? kRestart : static_cast<std::uint32_t>(index));
        }
    }

    void skip(const PlyElement& element)
    {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            source_.begin_element(elements_left_--);
            for (const PlyProperty& property : element.properties) skip(property);
        }
    }

    void skip(const PlyProperty& property)
    {
        if (property.is_list)
            skip_list(property);
        else
            source_.skip(property.type, 1);
    }

    void skip_list(const PlyProperty& property)
    {
        const std::int64_t count = source_.length_to_skip(property.count_type, kLength);
        if (count < 0) source_.fail("a list has a negative length; export it again");
        source_.skip(property.type, static_cast<std::uint64_t>(count));
    }

    /// If there are faces but none has corners, the name of their list may be to blame.
    void check_list_names() const
    {
        for (const PlyElement& element : header_.elements)
            if (element.name == "face" && element.count > 0 &&
                std::none_of(element.properties.begin(), element.properties.end(), lists_vertices))
                fail(path_, "its faces have no list 'vertex_indices'; name the list of their corners so");
    }

    static constexpr std::string_view kLength = "the length of a list";
    static constexpr std::uint32_t kRestart = 0xFFFFFFFFu;

    const std::filesystem::path& path_;
    const PlyHeader& header_;
    Source source_;
    ReadingNotes& notes_;
    SoupBuilder builder_;
    std::uint64_t vertex_count_ = 0, elements_left_ = 0;
    std::vector<std::uint32_t> corners_;
    std::vector<std::size_t> face_sizes_;
};

/// The lines and elements of a text are counted to find out how they match. If some elements share lines and others
/// take several, the counts tell nothing: then it is read as elements in order, if it has exactly their numbers.
TriangleSoup read_text(const std::filesystem::path& path, const PlyHeader& header, std::string_view body,
                       ReadingNotes& notes)
{
    std::optional<TriangleSoup> soup;
    std::optional<FileError> error;
    ReadingNotes counted_notes = notes;
    try {
        PlyReader reader(path, header, TextSource(path, body, header, counted_notes), counted_notes);
        soup = reader.read();
        if (!reader.source().is_doubtful()) {
            notes = std::move(counted_notes);
            return *std::move(soup);
        }
    } catch (const FileError& caught) {
        error = caught;
    }
    try {
        ReadingNotes ordered_notes = notes;
        TextSource source(path, body, header, ordered_notes);
        source.take_elements_in_order();
        TriangleSoup ordered = PlyReader(path, header, source, ordered_notes).read();
        notes = std::move(ordered_notes);
        return ordered;
    } catch (const FileError&) {
        if (error) throw *error;
    }
    notes = std::move(counted_notes);
    return *std::move(soup);
}

}  // namespace

TriangleSoup read_ply(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    const PlainText text(bytes, notes);
    const PlyHeader header = read_ply_header(path, text, notes);
    if (header.format == PlyFormat::ascii) {
        const std::string_view body = without_padding(text.view().substr(header.size), notes);
        return read_text(path, header, body, notes);
    }
    return PlyReader(path, header, BinarySource(path, bytes, header), notes).read();
}

}  // namespace kerf::core::io
