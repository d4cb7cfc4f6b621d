#pragma once

#include <cstdint>

// A curve through the cells of a square grid on which neighbours are near each other (Morton 1966): numbers of cells are
// places along it.

namespace kerf::core {

/// The place of the cell in column x and row y, both below 65536.
inline std::uint32_t morton(std::uint32_t x, std::uint32_t y)
{
    const auto spread = [](std::uint32_t v) {
        v = (v | (v << 8)) & 0x00ff00ffu;
        v = (v | (v << 4)) & 0x0f0f0f0fu;
        v = (v | (v << 2)) & 0x33333333u;
        return (v | (v << 1)) & 0x55555555u;
    };
    return spread(x) | (spread(y) << 1);
}

}  // namespace kerf::core
