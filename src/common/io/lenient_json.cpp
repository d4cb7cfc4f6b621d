#include "common/io/lenient_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace kerf::core::io {

namespace {

/// Text that strict parsers accept, and a record of what was changed for it.
struct Mended
{
    std::string text;
    std::vector<std::size_t> grown;  ///< places in `text` behind which it is one byte longer than the original
    std::uint64_t control_characters = 0, letters = 0, numbers = 0;
};

bool is_word(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '+' || c == '-' ||
           c == '.' || c == '#' || c == '_' || c == '(' || c == ')';
}

/// "NaN", "-nan(ind)", "inf", "Infinity", "1.#QNAN", "-1.#IND", 1e400: the ways in which programs write numbers that
/// are not finite.
bool is_no_finite_number(std::string_view word)
{
    std::string lower(word.substr(0, 16));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    std::string_view bare = lower;
    if (bare.starts_with('-') || bare.starts_with('+')) bare.remove_prefix(1);
    if (bare == "nan" || bare.starts_with("nan(") || bare == "inf" || bare == "infinity" || bare.starts_with("1.#"))
        return true;
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    // A number that is too small is out of range as well, and is no fault: parsers read it as 0.
    const std::size_t exponent = word.find_first_of("eE");
    return error == std::errc::result_out_of_range && end == word.data() + word.size() &&
           (exponent == std::string_view::npos || word[exponent + 1] != '-');
}

/// Bytes of the UTF-8 sequence at the start of `text`; 0 if there is none (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto follows = [&](std::size_t i, unsigned lo = 0x80, unsigned hi = 0xBF) {
        return byte(i) >= lo && byte(i) <= hi;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
    if (first >= 0xE0 && first <= 0xEF)
        return follows(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF) && follows(2) ? 3 : 0;
    if (first >= 0xF0 && first <= 0xF4)
        return follows(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF) && follows(2) && follows(3) ? 4 : 0;
    return 0;
}

Mended mend(std::string_view text)
{
    Mended mended;
    std::string& out = mended.text;
    out.reserve(text.size());
    bool in_text = false;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (!in_text && is_word(c)) {
            std::size_t end = i;
            while (end < text.size() && is_word(text[end])) ++end;
            const std::string_view word = text.substr(i, end - i);
            if (is_no_finite_number(word)) {
                ++mended.numbers;
                out += "\"\"" + std::string(word.size() - 2, ' ');  // no such word is shorter than three letters
            } else {
                out += word;
            }
            i = end;
            continue;
        }
        if (c == '"') in_text = !in_text;
        if (!in_text) {
            out += c;
            ++i;
        } else if (c == '\\' && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0x80) {
            out += text.substr(i, 2);
            i += 2;
        } else if (static_cast<unsigned char>(c) < ' ') {
            ++mended.control_characters;
            out += ' ';
            ++i;
        } else if (const std::size_t length = utf8_length(text.substr(i, 4)); length > 0) {
            out += text.substr(i, length);
            i += length;
        } else {
            ++mended.letters;
            const auto letter = static_cast<unsigned char>(c);
            out += static_cast<char>(0xC0 | letter >> 6);
            out += static_cast<char>(0x80 | (letter & 0x3F));
            mended.grown.push_back(out.size());
            ++i;
        }
    }
    return mended;
}

/// The document, or the place of the first fault.
std::optional<std::size_t> parse(std::string_view text, nlohmann::json& document)
{
    try {
        document = nlohmann::json::parse(text);
        return std::nullopt;
    } catch (const nlohmann::json::parse_error& error) {
        return error.byte;
    } catch (const nlohmann::json::exception&) {
        return 0;  // a number too large for a double: the parser does not say which
    }
}

}  // namespace

nlohmann::json parse_lenient_json(std::string_view text, ReadingNotes& notes)
{
    nlohmann::json document;
    // The parser takes a zero byte outside of strings for the end.
    const auto note_end = [&](std::string_view parsed) {
        const std::size_t end = std::min(parsed.find('\0'), parsed.size());
        notes.add(kBytesBehind, parsed.size() - end);
    };
    if (!parse(text, document)) {
        note_end(text);
        return document;
    }
    const Mended mended = mend(text);
    if (const auto fault = parse(mended.text, document)) {
        const auto before = std::upper_bound(mended.grown.begin(), mended.grown.end(), *fault) - mended.grown.begin();
        throw JsonError(*fault - static_cast<std::size_t>(before));
    }
    note_end(mended.text);
    notes.add("control characters inside texts of the JSON taken as spaces", mended.control_characters);
    notes.add("letters of the JSON that are not UTF-8 taken as Latin-1", mended.letters);
    notes.add("numbers of the JSON that are not finite passed over", mended.numbers);
    return document;
}

}  // namespace kerf::core::io
