#include "viewer/effects/popups.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::effects {

float Popup::scale() const
{
    constexpr float kIn = 0.16f, kOver = 1.9f;  // seconds; how far beyond its size it springs
    const float x = std::min(age / kIn, 1.0f) - 1.0f;
    return 1.0f + (kOver + 1.0f) * x * x * x + kOver * x * x;
}

float Popup::rise() const
{
    return 0.75f * (1.0f - std::exp(-1.6f * age));
}

float Popup::opacity() const
{
    constexpr float kFadeFrom = 0.72f;  // share of its life
    return std::clamp((1.0f - age / life) / (1.0f - kFadeFrom), 0.0f, 1.0f);
}

namespace {

/// Half the space that a text takes on the stage, metres: letters of size 1 are 34 of 720 units high, and the stage is
/// 8 m; a letter is about half as wide as high.
glm::vec2 half_extent(const Popup& popup)
{
    constexpr float kHeight = 34.0f / 720.0f * 8.0f, kWidth = 0.52f;
    std::size_t lines = 1, longest = 0, length = 0;
    for (const char letter : popup.text) {
        length = letter == '\n' ? 0 : length + 1;
        if (letter == '\n') ++lines;
        longest = std::max(longest, length);
    }
    return 0.5f * kHeight * popup.size * glm::vec2(kWidth * static_cast<float>(longest), static_cast<float>(lines));
}

/// Now, or when both have risen.
bool collide(const Popup& a, const Popup& b)
{
    const glm::vec2 room = half_extent(a) + half_extent(b);
    if (std::abs(a.place.x - b.place.x) >= room.x) return false;
    const float apart = a.place.y - b.place.y;
    return std::min(std::abs(apart), std::abs(apart + a.rise() - b.rise())) < room.y;
}

}  // namespace

void Popups::add(Popup popup)
{
    constexpr float kStep = 0.15f, kHighest = 2.9f, kLowest = -3.6f;  // metres
    constexpr int kTries = 40;
    const float wanted = popup.place.y;
    const auto is_covered = [&] {
        return std::any_of(popups_.begin(), popups_.end(), [&](const Popup& other) { return collide(popup, other); });
    };
    // 0, 1, -1, 2, -2, ... steps
    for (int i = 1; i <= kTries && is_covered(); ++i) {
        const float steps = static_cast<float>(i % 2 == 1 ? i / 2 + 1 : -(i / 2));
        popup.place.y = std::clamp(wanted + kStep * steps, kLowest, kHighest);
    }
    if (is_covered()) popup.place.y = wanted;
    if (popups_.size() >= kMost) popups_.erase(popups_.begin());
    popups_.push_back(std::move(popup));
}

void Popups::advance(float seconds)
{
    for (Popup& popup : popups_) popup.age += seconds;
    std::erase_if(popups_, [](const Popup& popup) { return popup.age >= popup.life; });
}

}  // namespace kerf::effects
