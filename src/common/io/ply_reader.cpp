#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/ply_header.h"
#include "common/io/ply_names.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/io/text_scanner.h"

namespace kerf::io {

namespace {

/// Numbers of an ASCII file, one word each.
class TextSource
{
public:
    TextSource(const std::filesystem::path& path, std::string_view bytes, const PlyHeader& header)
        : words_(path, bytes.substr(header.size), TextScanner::Syntax{})
    {
        words_.set_line(header.lines + 1);
    }

    // Whatever the type: the float nearest to the decimal number, not to the double nearest to it.
    float number(PlyType) { return words_.to_number(words_.word_of_any_line(), "a number"); }
    std::int64_t integer(PlyType) { return words_.to_integer(words_.word_of_any_line(), "an integer"); }
    void skip(PlyType, std::uint64_t count)
    {
        for (std::uint64_t i = 0; i < count; ++i)
            if (words_.word_of_any_line().empty()) fail("a number is missing; export it again");
    }
    [[noreturn]] void fail(const std::string& reason) const { words_.fail(reason); }

private:
    TextScanner words_;
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

    float number(PlyType type)
    {
        switch (type) {
            case PlyType::float32:
                return load<float>(take(4), order_);
            case PlyType::float64:
                return static_cast<float>(load<double>(take(8), order_));
            default:
                return static_cast<float>(integer(type));
        }
    }

    std::int64_t integer(PlyType type)
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
            case PlyType::float32:
            case PlyType::float64:
                break;
        }
        fail("an index is not an integer; give indices an integer type");
    }

    void skip(PlyType type, std::uint64_t count)
    {
        if (count > (bytes_.size() - at_) / size_of(type)) fail("it is truncated; export it again");
        at_ += static_cast<std::size_t>(count) * size_of(type);
    }

    [[noreturn]] void fail(const std::string& reason) const
    {
        io::fail(path_, reason + " (at byte " + std::to_string(at_) + " of " + std::to_string(bytes_.size()) + ")");
    }

private:
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
};

template <class Source>
class PlyReader
{
public:
    PlyReader(const std::filesystem::path& path, const PlyHeader& header, Source source, ReadingNotes& notes)
        : path_(path), header_(header), source_(std::move(source)), builder_(path, notes)
    {
        for (const PlyElement& element : header_.elements)
            if (element.name == "vertex") vertex_count_ += element.count;
    }

    TriangleSoup read()
    {
        bool has_vertices = false;
        for (const PlyElement& element : header_.elements) {
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
        // Faces may stand before their vertices.
        for (std::size_t i = 0, first = 0; i < face_sizes_.size(); first += face_sizes_[i], ++i)
            builder_.add_face(std::span(corners_).subspan(first, face_sizes_[i]));
        return builder_.finish();
    }

private:
    void read_vertices(const PlyElement& element)
    {
        const PlyVertexLayout layout = ply_vertex_layout(element);
        if (!layout.has_position) fail(path_, "its vertices have no x, y and z; name their coordinates so");
        builder_.soup.vertices.reserve(element.count);
        for (const PlyStream& stream : layout.streams) {
            builder_.soup.streams.push_back({stream.name, stream.width, {}});
            builder_.soup.streams.back().values.resize(element.count * stream.width);
        }
        std::vector<VertexStream>& streams = builder_.soup.streams;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            // As floats: position, normal, uv.
            std::array<float, 8> core{};
            for (std::size_t k = 0; k < element.properties.size(); ++k) {
                const PlyProperty& property = element.properties[k];
                const PlyDestination& to = layout.destinations[k];
                if (property.is_list) {
                    skip_list(property);
                    continue;
                }
                const float value = source_.number(property.type);
                if (to.stream == PlyDestination::kCore)
                    core[to.component] = value;
                else
                    streams[to.stream].values[i * streams[to.stream].width + to.component] = value / to.one;
            }
            builder_.add_vertex({{core[0], core[1], core[2]}, {core[3], core[4], core[5]}, {core[6], core[7]}});
        }
    }

    void read_faces(const PlyElement& element)
    {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
            for (const PlyProperty& property : element.properties) {
                if (property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index")) {
                    const std::size_t first = corners_.size();
                    read_indices(property, 0);
                    face_sizes_.push_back(corners_.size() - first);
                } else {
                    skip(property);
                }
            }
    }

    /// Strips of triangles, several in a list, separated by -1; every other triangle is turned over.
    void read_strips(const PlyElement& element)
    {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
            for (const PlyProperty& property : element.properties) {
                if (!property.is_list || (property.name != "vertex_indices" && property.name != "vertex_index")) {
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

    /// Appends a list of indices to `corners_`; those down to `least` that are no vertex become kRestart.
    void read_indices(const PlyProperty& property, std::int64_t least)
    {
        const std::int64_t count = source_.integer(property.count_type);
        if (count < 0) source_.fail("a list of indices has a negative length; export it again");
        for (std::int64_t k = 0; k < count; ++k) {
            const std::int64_t index = source_.integer(property.type);
            if (index < least || (index >= 0 && static_cast<std::uint64_t>(index) >= vertex_count_))
                source_.fail("vertex " + std::to_string(index) + " is out of range: there are " +
                             std::to_string(vertex_count_) + ", counted from 0; mend the face or take it out");
            corners_.push_back(index < 0 ? kRestart : static_cast<std::uint32_t>(index));
        }
    }

    void skip(const PlyElement& element)
    {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
            for (const PlyProperty& property : element.properties) skip(property);
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
        const std::int64_t count = source_.integer(property.count_type);
        if (count < 0) source_.fail("a list has a negative length; export it again");
        source_.skip(property.type, static_cast<std::uint64_t>(count));
    }

    static constexpr std::uint32_t kRestart = 0xFFFFFFFFu;

    const std::filesystem::path& path_;
    const PlyHeader& header_;
    Source source_;
    SoupBuilder builder_;
    std::uint64_t vertex_count_ = 0;
    std::vector<std::uint32_t> corners_;
    std::vector<std::size_t> face_sizes_;
};

}  // namespace

TriangleSoup read_ply(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    const PlyHeader header = read_ply_header(path, bytes);
    if (header.format == PlyFormat::ascii)
        return PlyReader(path, header, TextSource(path, bytes, header), notes).read();
    return PlyReader(path, header, BinarySource(path, bytes, header), notes).read();
}

}  // namespace kerf::io
