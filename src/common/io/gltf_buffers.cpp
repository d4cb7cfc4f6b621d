#include "common/io/gltf_buffers.h"
#include "common/files/read_file.h"

#include <algorithm>
#include <array>
#include <optional>

#include "common/io/read_formats.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

constexpr std::string_view kInside = "data:", kBase64 = ";base64,";  ///< in either case

bool is_same_letter(char c, char lower)
{
    return (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) == lower;
}

/// Value of a base64 digit; 64 for anything else.
constexpr std::array<std::uint8_t, 256> kDigitValues = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(64);
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < kDigits.size(); ++i)
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
    return values;
}();

bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

std::optional<std::string> percent_decoded(std::string_view text)
{
    const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; };
    const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || ((c | 0x20) >= 'a' && (c | 0x20) <= 'f'); };
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded.push_back(text[i]);
            continue;
        }
        if (i + 2 >= text.size() || !is_digit(text[i + 1]) || !is_digit(text[i + 2])) return std::nullopt;
        decoded.push_back(static_cast<char>(digit(text[i + 1]) * 16 + digit(text[i + 2])));
        i += 2;
    }
    return decoded;
}

bool is_data_uri(std::string_view uri)
{
    const std::string_view scheme = uri.substr(0, kInside.size());
    return std::equal(scheme.begin(), scheme.end(), kInside.begin(), kInside.end(), is_same_letter);
}

std::string_view GltfBuffers::bytes_of(const std::string& uri, const std::string& where)
{
    const auto known = bytes_.find(uri);
    if (known != bytes_.end()) return known->second;
    std::string bytes = is_data_uri(uri) ? decode(uri, where) : read_beside(uri, where);
    return bytes_.emplace(uri, std::move(bytes)).first->second;
}

std::string GltfBuffers::decode(std::string_view uri, const std::string& where)
{
    const auto mark = std::search(uri.begin(), uri.end(), kBase64.begin(), kBase64.end(), is_same_letter);
    if (mark == uri.end()) fail(path_, where + " has data that are not base64; export it again");
    std::string_view digits = uri.substr(static_cast<std::size_t>(mark - uri.begin()) + kBase64.size());
    // Some libraries escape +, / and =. A sign that escapes nothing is no digit.
    std::optional<std::string> decoded;
    if (digits.find('%') != std::string_view::npos) decoded = percent_decoded(digits);
    if (decoded) digits = *decoded;
    while (!digits.empty() && (digits.back() == '=' || is_space(digits.back()))) digits.remove_suffix(1);
    std::string bytes;
    bytes.reserve(digits.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    std::uint64_t spaces = 0;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const std::uint8_t value = kDigitValues[static_cast<unsigned char>(digits[i])];
        if (value == 64 && is_space(digits[i])) {
            ++spaces;
            continue;
        }
        if (value == 64)
            fail(path_,
                 where + " has data that are not base64: digit " + std::to_string(i) + " is none; export it again");
        bits = bits << 6 | value;
        // Every digit but the first of four completes a byte.
        if (const std::size_t k = (i - spaces) % 4; k != 0)
            bytes.push_back(static_cast<char>(bits >> (6 - 2 * k) & 0xFFu));
    }
    notes_.add("line ends and spaces in base64 passed over", spaces);
    return bytes;
}

std::string GltfBuffers::read_beside(std::string_view uri, const std::string& where)
{
    auto name = percent_decoded(uri);
    if (name && name->find('\\') != std::string::npos) {
        std::replace(name->begin(), name->end(), '\\', '/');
        notes_.add("backslashes in names of files taken as slashes");
    }
    const auto beside = name ? file_beside(path_, *name) : std::nullopt;
    if (!beside)
        fail(path_,
             where + " names " + in_quotes(uri) +
                 ": buffers must lie in the folder of the file or below it; copy it there and name it so, or put the "
                 "buffer into the file");
    std::error_code error;
    const auto type = std::filesystem::status(*beside, error).type();
    if (type == std::filesystem::file_type::not_found)
        fail(path_, where + " names " + in_quotes(*name) + ", which is not there; put it beside the file");
    if (type != std::filesystem::file_type::regular)
        fail(path_,
             where + " names " + in_quotes(*name) + ", which is not a regular file; put the buffer in its place");
    std::string bytes = read_bytes(*beside);
    beside_ += bytes.size();
    return bytes;
}

}  // namespace kerf::core::io
