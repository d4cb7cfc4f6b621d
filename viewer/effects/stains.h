#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace kerf::effects {

/// A splash of juice on the wall: it appears at once, runs down a little and dries away. World units and seconds.
struct Stain
{
    glm::vec2 place{0.0f};
    glm::vec3 colour{1.0f};  ///< linear
    float size = 0.5f;       ///< radius when it is complete
    float shape = 0.0f;      ///< 0 to 1: which of endlessly many outlines
    float age = 0.0f;

    float spread() const;   ///< 0 to 1: how much of the size is reached
    float run() const;      ///< how far the longest drip has run down, in sizes
    float opacity() const;  ///< 1 to 0
    float wetness() const;  ///< 1: new, 0: it has soaked in
};

/// The stains on the wall, at most kMost: the oldest make room.
class Stains
{
public:
    static constexpr std::size_t kMost = 64;
    static constexpr float kWet = 1.6f;   ///< seconds before it begins to fade
    static constexpr float kLife = 6.0f;  ///< seconds until it is gone

    void add(const Stain& stain);
    void advance(float seconds);
    void clear() { stains_.clear(); }

    /// Oldest first.
    std::span<const Stain> all() const { return stains_; }

private:
    std::vector<Stain> stains_;
};

}  // namespace kerf::effects
