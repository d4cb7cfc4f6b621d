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
    constexpr float kFadeFrom = 0.6f;  // share of its life
    return std::clamp((1.0f - age / life) / (1.0f - kFadeFrom), 0.0f, 1.0f);
}

void Popups::add(Popup popup)
{
    if (popups_.size() >= kMost) popups_.erase(popups_.begin());
    popups_.push_back(std::move(popup));
}

void Popups::advance(float seconds)
{
    for (Popup& popup : popups_) popup.age += seconds;
    std::erase_if(popups_, [](const Popup& popup) { return popup.age >= popup.life; });
}

}  // namespace kerf::effects
