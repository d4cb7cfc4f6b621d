#include "common/io/plain_text.h"

#include <cstddef>
#include <cstdint>
#include <optional>

#include "common/io/bytes.h"

namespace kerf::core::io {

namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;  ///< for half a pair of surrogates

std::optional<Endian> order_of_utf16(std::string_view bytes)
{
    if (bytes.starts_with("\xFF\xFE")) return Endian::little;
    if (bytes.starts_with("\xFE\xFF")) return Endian::big;
    if (bytes.size() < 4) return std::nullopt;
    const auto is_ascii = [&](std::size_t at) { return bytes[at] >= '\t' && bytes[at] < '\x7F'; };
    if (is_ascii(0) && bytes[1] == '\0' && is_ascii(2) && bytes[3] == '\0') return Endian::little;
    if (bytes[0] == '\0' && is_ascii(1) && bytes[2] == '\0' && is_ascii(3)) return Endian::big;
    return std::nullopt;
}

void append_utf8(std::string& text, std::uint32_t code)
{
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    const auto put_low = [&](std::uint32_t shift) { put(0x80 | ((code >> shift) & 0x3F)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        put_low(0);
    } else if (code < 0x10000) {
        put(0xE0 | (code >> 12));
        put_low(6);
        put_low(0);
    } else {
        put(0xF0 | (code >> 18));
        put_low(12);
        put_low(6);
        put_low(0);
    }
}

/// Converts without the byte order mark, if there is one. An incomplete last unit is cut off.
std::string utf8_of_utf16(std::string_view bytes, Endian order)
{
    constexpr std::size_t kUnit = 2;
    std::string text;
    text.reserve(bytes.size() / kUnit);
    const auto unit = [&](std::size_t at) -> std::uint32_t { return load<std::uint16_t>(bytes.data() + at, order); };
    const auto is_high = [](std::uint32_t u) { return u >= 0xD800 && u < 0xDC00; };
    const auto is_low = [](std::uint32_t u) { return u >= 0xDC00 && u < 0xE000; };
    constexpr std::uint32_t kMark = 0xFEFF;
    const bool has_mark = unit(0) == kMark;
    for (std::size_t at = has_mark ? kUnit : 0; at + kUnit <= bytes.size(); at += kUnit) {
        std::uint32_t code = unit(at);
        if (is_high(code) && at + 2 * kUnit <= bytes.size() && is_low(unit(at + kUnit))) {
            code = 0x10000 + ((code - 0xD800) << 10) + (unit(at + kUnit) - 0xDC00);
            at += kUnit;
        } else if (is_high(code) || is_low(code)) {
            code = kReplacement;
        }
        append_utf8(text, code);
    }
    return text;
}

}  // namespace

PlainText::PlainText(std::string_view bytes, ReadingNotes& notes) : text_(bytes)
{
    if (const auto order = order_of_utf16(bytes)) {
        text_ = converted_ = utf8_of_utf16(bytes, *order);
        notes.add("text in UTF-16 converted");
    }
}

std::string_view without_padding(std::string_view text, ReadingNotes& notes)
{
    constexpr std::string_view kPadding("\0\x1A", 2);
    const std::size_t last = text.find_last_not_of(kPadding);
    const std::size_t size = last == std::string_view::npos ? 0 : last + 1;
    notes.add("bytes that fill up the end of the file passed over", text.size() - size);
    return text.substr(0, size);
}

}  // namespace kerf::core::io
