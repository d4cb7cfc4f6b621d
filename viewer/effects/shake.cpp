#include "viewer/effects/shake.h"

#include <algorithm>
#include <cmath>

namespace kerf::effects {

void Shake::hit(float force)
{
    if (force_ <= 0.0f) time_ = 0.0f;
    force_ = std::clamp(force_ + force, 0.0f, 1.0f);
}

void Shake::advance(float seconds)
{
    constexpr float kRecovery = 1.7f;  // force lost in a second
    time_ += seconds;
    force_ = std::max(force_ - kRecovery * seconds, 0.0f);
}

glm::vec2 Shake::offset() const
{
    // Sines whose frequencies share no period, weighed so that the sum stays within -1 to 1.
    const float far = kFarthest * force_ * force_;
    return far * glm::vec2(0.6f * std::sin(61.0f * time_) + 0.4f * std::sin(97.3f * time_ + 1.0f),
                           0.6f * std::sin(71.7f * time_ + 2.0f) + 0.4f * std::sin(109.1f * time_));
}

}  // namespace kerf::effects
