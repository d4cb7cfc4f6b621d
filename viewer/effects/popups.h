#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace kerf::effects {

/// A word or a number that appears where something happened: it pops up, rises and fades.
struct Popup
{
    glm::vec2 place{0.0f};  ///< on the stage, metres
    std::string text;
    glm::vec3 colour{1.0f};  ///< sRGB
    float size = 1.0f;       ///< 1: a score; 2: a combo
    float life = 1.1f;       ///< seconds
    float age = 0.0f;

    float scale() const;    ///< of the letters: 0, a little over 1, then 1
    float rise() const;     ///< above its place, metres
    float opacity() const;  ///< 0 to 1
};

/// At most kMost; the oldest make room. What would cover another one appears above or below it.
class Popups
{
public:
    static constexpr std::size_t kMost = 24;

    void add(Popup popup);
    void advance(float seconds);
    void clear() { popups_.clear(); }

    /// Oldest first.
    std::span<const Popup> all() const { return popups_; }

private:
    std::vector<Popup> popups_;
};

}  // namespace kerf::effects
