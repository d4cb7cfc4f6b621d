#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "fuzz/fuzzer.h"

namespace kerf::core::fuzz {

/// Makes numbers out of a fuzzer's bytes, front to back. Zeros follow where the bytes end, so any prefix of an input is
/// an input, and changing one byte changes one number.
class ByteReader
{
public:
    explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

    bool empty() const { return at_ >= bytes_.size(); }

    std::uint8_t byte() { return empty() ? std::uint8_t{0} : bytes_[at_++]; }
    std::uint32_t below(std::uint32_t bound) { return (bound <= 256 ? byte() : word()) % bound; }
    std::uint32_t word()
    {
        std::uint32_t value = 0;
        for (int i = 0; i < 4; ++i) value = value << 8 | byte();
        return value;
    }
    std::uint64_t long_word()
    {
        const std::uint64_t high = word();
        return high << 32 | word();
    }

    /// A finite coordinate. Mostly on a coarse grid, so that corners, edges and faces meet; sometimes a few units in
    /// the last place beside it, sometimes any float of at most 2^`largest_exponent`.
    float coordinate(int largest_exponent)
    {
        const std::uint8_t kind = byte();
        if (kind < 0xC0) return static_cast<float>(static_cast<int>(kind % 16) - 8) * 0.5f;
        if (kind < 0xE0) {
            float value = static_cast<float>(static_cast<int>(byte() % 16) - 8) * 0.5f;
            for (int i = 0; i < kind % 4 + 1; ++i) value = std::nextafter(value, kind % 8 < 4 ? -100.0f : 100.0f);
            return value + 0.0f;
        }
        const float value = std::bit_cast<float>(word());
        return std::isfinite(value) && std::abs(value) <= std::ldexp(1.0f, largest_exponent) ? value + 0.0f : 0.0f;
    }

private:
    Bytes bytes_;
    std::size_t at_ = 0;
};

}  // namespace kerf::core::fuzz
