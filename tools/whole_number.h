#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <string>

namespace kerf::tools {

/// Lets whole numbers of a range through, and says of anything else what is asked for: "'x' is no whole number from 1
/// to 9". CLI11's own checks say that a value "could not be converted".
inline CLI::Validator whole_number(std::uint64_t least = 0,
                                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max())
{
    const bool is_bounded = most < std::numeric_limits<std::uint64_t>::max();
    const std::string range = is_bounded ? "from " + std::to_string(least) + " to " + std::to_string(most)
                                         : "of " + std::to_string(least) + " or more";
    const auto check = [least, most, range](std::string& text) -> std::string {
        std::uint64_t value = 0;
        // CLI11 takes a minus and counts down from the largest number.
        const bool is_negative = text.starts_with('-');
        if (!is_negative && CLI::detail::lexical_cast(text, value) && value >= least && value <= most) return {};
        return "'" + text + "' is no whole number " + range;
    };
    return CLI::Validator(check, "");
}

}  // namespace kerf::tools
