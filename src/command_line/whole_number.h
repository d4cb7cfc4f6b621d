#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

namespace kerf::command_line {

/// For Option::transform(): lets decimal whole numbers of a range through, and says of anything else what is asked for:
/// "'x' is no whole number from 1 to 9". CLI11's own checks say that a value "could not be converted", count down from
/// the largest number for a minus, and take the largest number for any that is larger; and it reads 010 as 8.
inline CLI::Validator whole_number(std::uint64_t least = 0,
                                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max())
{
    const auto check = [least, most](std::string& text) -> std::string {
        const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
        const char* const end = text.data() + text.size();
        std::uint64_t value = 0;
        const auto [behind, error] = std::from_chars(begin, end, value);
        if (error != std::errc() || behind != end || value < least || value > most)
            return "'" + text + "' is no whole number from " + std::to_string(least) + " to " + std::to_string(most);
        text = std::to_string(value);
        return {};
    };
    return CLI::Validator(check, "");
}

}  // namespace kerf::command_line
