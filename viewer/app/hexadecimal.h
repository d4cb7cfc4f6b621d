#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

namespace kerf::app {

/// A hash as reports write it: sixteen digits.
inline std::string hexadecimal(std::uint64_t word)
{
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(word));
    return text.data();
}

}  // namespace kerf::app
