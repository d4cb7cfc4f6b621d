#include "common/reason.h"

namespace kerf {

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t kLongest = 40;
    std::string result = "'";
    for (const char c : text.substr(0, kLongest)) result += (c >= ' ' && c != '\x7f') || c < 0 ? c : '?';
    return result + (text.size() > kLongest ? "...'" : "'");
}

std::string but_there_are_only(std::uint64_t count)
{
    if (count == 0) return ", but there is none";
    return ", but there are only " + std::to_string(count) + ", counted from 0";
}

}  // namespace kerf
