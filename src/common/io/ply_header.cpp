#include "common/io/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "common/io/read_formats.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

/// Nothing for a word that names no type.
std::optional<PlyType> find_type(std::string_view word)
{
    constexpr std::array<std::pair<std::string_view, PlyType>, 18> kNames{{
        {"char", PlyType::int8},
        {"int8", PlyType::int8},
        {"uchar", PlyType::uint8},
        {"uint8", PlyType::uint8},
        {"short", PlyType::int16},
        {"int16", PlyType::int16},
        {"ushort", PlyType::uint16},
        {"uint16", PlyType::uint16},
        {"int", PlyType::int32},
        {"int32", PlyType::int32},
        {"uint", PlyType::uint32},
        {"uint32", PlyType::uint32},
        // Not in the description, but what NumPy's programs write.
        {"int64", PlyType::int64},
        {"uint64", PlyType::uint64},
        {"float", PlyType::float32},
        {"float32", PlyType::float32},
        {"double", PlyType::float64},
        {"float64", PlyType::float64},
    }};
    for (const auto& [name, type] : kNames)
        if (name == word) return type;
    return std::nullopt;
}

/// In a text a number can be read whatever its type is called; in a binary file an unknown type has an unknown size.
PlyType to_type(const TextScanner& line, std::string_view word, bool is_ascii, ReadingNotes& notes)
{
    if (const std::optional<PlyType> type = find_type(word)) return *type;
    if (!is_ascii || word.empty())
        line.fail(in_quotes(word) +
                  " is not a type of property; the types of PLY are char to double and int8 to float64");
    notes.add("types of properties that PLY does not have taken as numbers");
    return PlyType::float64;
}

PlyFormat to_format(const TextScanner& line, std::string_view word)
{
    if (word == "ascii") return PlyFormat::ascii;
    if (word == "binary_little_endian") return PlyFormat::little_endian;
    if (word == "binary_big_endian") return PlyFormat::big_endian;
    line.fail(in_quotes(word) +
              " is not a format of PLY files; those are ascii, binary_little_endian and binary_big_endian 1.0");
}

PlyProperty read_property(TextScanner& line, bool is_ascii, ReadingNotes& notes)
{
    PlyProperty property;
    std::string_view word = line.word();
    if (word == "list") {
        property.is_list = true;
        property.count_type = to_type(line, line.word(), is_ascii, notes);
        word = line.word();
    }
    property.type = to_type(line, word, is_ascii, notes);
    property.name = line.word();
    if (property.name.empty()) line.fail("a property has no name; give it one");
    return property;
}

/// Bytes that one element takes at least. As text each number takes two with its separator.
std::uint64_t least_size(const PlyElement& element, PlyFormat format)
{
    std::uint64_t size = 0;
    for (const PlyProperty& p : element.properties)
        size += format == PlyFormat::ascii ? 2 : size_of(p.is_list ? p.count_type : p.type);
    return size;
}

void check_room(const TextScanner& line, const PlyHeader& header)
{
    // The last number of a text needs no separator.
    std::uint64_t room = line.bytes_left() + 1;
    for (const PlyElement& element : header.elements) {
        const std::uint64_t size = least_size(element, header.format);
        if (size > 0 && element.count > room / size)
            line.fail("element " + in_quotes(element.name) + " is said to occur " + std::to_string(element.count) +
                      " times, which is more than the file has room for; mend the count or export it again");
        room -= element.count * size;
    }
}

}  // namespace

std::size_t size_of(PlyType type)
{
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::int64:
        case PlyType::uint64:
        case PlyType::float64:
            return 8;
    }
    return 0;
}

/// Bytes of the header that ends where `line` is. In a binary file whose header lines end with CR, a LF behind the last
/// one belongs to the numbers.
std::size_t header_size(std::string_view bytes, const TextScanner& line)
{
    const std::size_t size = bytes.size() - line.bytes_left();
    const std::size_t first_end = bytes.find_first_of("\r\n");
    const bool ends_with_cr = bytes[first_end] == '\r' && bytes[first_end + 1] != '\n';
    return size >= 2 && ends_with_cr && bytes.substr(size - 2, 2) == "\r\n" ? size - 1 : size;
}

PlyHeader read_ply_header(const std::filesystem::path& path, const PlainText& text, ReadingNotes& notes)
{
    const std::string_view bytes = text.view();
    TextScanner line(path, bytes, TextScanner::Syntax{}, &notes);
    PlyHeader header;
    const std::string_view magic = line.next_line() ? line.word() : std::string_view();
    if (magic == "PLY")
        notes.add("header that begins with PLY in capitals read");
    else if (magic != "ply")
        line.fail("it does not begin with 'ply'; export it again or mend its extension");
    bool has_format = false;
    for (;;) {
        if (!line.next_line()) line.fail("the file ends inside the header; export it again");
        const std::string_view keyword = line.word();
        if (keyword == "end_header") break;
        if (keyword == "format") {
            const PlyFormat format = to_format(line, line.word());
            if (has_format && format != header.format)
                line.fail("the header names a second format; take one of them out or export the file again");
            header.format = format;
            if (text.was_converted() && header.format != PlyFormat::ascii)
                line.fail("it is text in UTF-16, which destroys binary numbers; export it again");
            has_format = true;
        } else if (keyword == "element") {
            PlyElement element;
            element.name = line.word();
            const std::int64_t count = line.to_integer(line.word(), "the number of " + in_quotes(element.name));
            if (count < 0)
                line.fail("the number of " + in_quotes(element.name) +
                          " is negative; mend it or export the file again");
            element.count = static_cast<std::uint64_t>(count);
            header.elements.push_back(std::move(element));
        } else if (keyword == "property") {
            if (header.elements.empty()) line.fail("a property comes before the first element; put it behind one");
            const bool is_ascii = has_format && header.format == PlyFormat::ascii;
            header.elements.back().properties.push_back(read_property(line, is_ascii, notes));
        } else if (keyword != "comment" && keyword != "obj_info") {
            // Before the elements an unknown keyword is a remark. Behind one it may be a property, whose data would be
            // taken for others.
            if (!header.elements.empty())
                line.fail(in_quotes(keyword) +
                          " is not a keyword of PLY headers; take the line out or export the file again");
            notes.add("lines of the header that begin with no keyword passed over");
        }
    }
    if (!has_format) line.fail("the header does not name the format; add a line such as 'format ascii 1.0'");
    line.end_line();
    check_room(line, header);
    header.size = header_size(bytes, line);
    header.lines = line.line() - 1;
    return header;
}

}  // namespace kerf::core::io
