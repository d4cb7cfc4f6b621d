#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <limits>

namespace kerf::core {

/// Axis-aligned box lo <= p <= hi. A default box is empty: it contains nothing and grows from there.
struct Box
{
    glm::vec3 lo{std::numeric_limits<float>::infinity()};
    glm::vec3 hi{-std::numeric_limits<float>::infinity()};

    bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }

    void add(const glm::vec3& p)
    {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }

    void add(const Box& other)
    {
        lo = {std::min(lo.x, other.lo.x), std::min(lo.y, other.lo.y), std::min(lo.z, other.lo.z)};
        hi = {std::max(hi.x, other.hi.x), std::max(hi.y, other.hi.y), std::max(hi.z, other.hi.z)};
    }

    glm::dvec3 centre() const { return (glm::dvec3(lo) + glm::dvec3(hi)) * 0.5; }

    /// Largest absolute coordinate of any corner; 0 for an empty box.
    float largest_coordinate() const
    {
        if (empty()) return 0.0f;
        const auto magnitude = [](float a, float b) { return std::max(a < 0 ? -a : a, b < 0 ? -b : b); };
        return std::max({magnitude(lo.x, hi.x), magnitude(lo.y, hi.y), magnitude(lo.z, hi.z)});
    }
};

}  // namespace kerf::core
