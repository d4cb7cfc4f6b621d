#pragma once

#include <cstdint>

namespace kerf::core {

/// SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014). The distributions of the
/// standard library differ between implementations; this gives the same numbers everywhere.
class Random
{
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next()
    {
        state_ += 0x9E3779B97F4A7C15u;
        return mix(state_);
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    double unit() { return double(next() >> 11) * 0x1p-53; }

    /// 0 .. n-1 for 0 < n < 2^32; the bias is below n / 2^32.
    std::uint32_t below(std::uint32_t n) { return std::uint32_t(((next() >> 32) * n) >> 32); }

    /// The generator's output function: a good hash of one word.
    static std::uint64_t mix(std::uint64_t z)
    {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

private:
    std::uint64_t state_;
};

}  // namespace kerf::core
