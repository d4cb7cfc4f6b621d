#pragma once

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

namespace kerf::tools {

/// Lets whole numbers of a range through, and says of anything else what is asked for: "'x' is no whole number from 1
/// to 9". CLI11's own checks say that a value "could not be converted", count down from the largest number for a minus,
/// and take the largest number for any that is larger.
inline CLI::Validator whole_number(std::uint64_t least = 0,
                                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max())
{
    const auto check = [least, most](std::string& text) -> std::string {
        // What CLI11 converts: decimal, hexadecimal after 0x, octal after 0.
        char* end = nullptr;
        errno = 0;
        const std::uint64_t value = std::strtoull(text.c_str(), &end, 0);
        const bool is_number =
            errno == 0 && !text.empty() && end == text.c_str() + text.size() && text.find('-') == std::string::npos;
        if (is_number && value >= least && value <= most) return {};
        return "'" + text + "' is no whole number from " + std::to_string(least) + " to " + std::to_string(most);
    };
    return CLI::Validator(check, "");
}

}  // namespace kerf::tools
