#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

#include "common/support/random.h"

namespace kerf::sim {

/// Hash of everything that a state consists of, in order; numbers bit for bit. Not for adversaries.
class StateHash
{
public:
    void add(std::uint64_t word) { state_ = core::Random::mix((state_ ^ word) + 0x9E3779B97F4A7C15u); }
    void add(std::int64_t number) { add(static_cast<std::uint64_t>(number)); }
    void add(std::uint32_t number) { add(std::uint64_t(number)); }
    void add(bool flag) { add(std::uint64_t(flag)); }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(float number) { add(std::uint64_t(std::bit_cast<std::uint32_t>(number))); }
    void add(const glm::dvec3& v)
    {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    void add(std::string_view text)
    {
        add(std::uint64_t(text.size()));
        for (const char c : text) add(std::uint64_t(static_cast<unsigned char>(c)));
    }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0;
};

}  // namespace kerf::sim
