#include "common/support/reason.h"

#include <algorithm>

namespace kerf::core {

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t kLongest = 40;
    std::size_t length = std::min(text.size(), kLongest);
    // Do not cut inside a UTF-8 character, which takes four bytes at most.
    const auto is_inside = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u; };
    for (int i = 0; i < 3 && length < text.size() && length > 0 && is_inside(length); ++i) --length;
    std::string result = "'";
    for (const char c : text.substr(0, length)) result += (c >= ' ' && c != '\x7f') || c < 0 ? c : '?';
    return result + (text.size() > length ? "...'" : "'");
}

std::string but_there_are_only(std::uint64_t count)
{
    if (count == 0) return ", but there is none";
    return ", but there are only " + std::to_string(count) + ", counted from 0";
}

}  // namespace kerf::core
