#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace kerf::core::io {

enum class Endian : std::uint8_t
{
    little,
    big
};

/// A number of a binary file, at any address.
template <class T>
T load(const char* place, Endian order)
{
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), place, sizeof(T));
    if ((order == Endian::little) != (std::endian::native == std::endian::little))
        std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
}

/// Appends a number, least significant byte first.
template <class T>
void store_little(std::string& bytes, T value)
{
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

}  // namespace kerf::core::io
