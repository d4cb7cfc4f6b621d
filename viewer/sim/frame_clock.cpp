#include "viewer/sim/frame_clock.h"

#include <algorithm>
#include <cmath>

namespace kerf::sim {

Tick FrameClock::advance(double seconds)
{
    if (paused_) {
        const bool step = single_step_;
        single_step_ = false;
        return step ? kTicksPerFrame : 0;
    }
    single_step_ = false;
    if (!std::isfinite(seconds) || seconds < 0.0) seconds = 0.0;
    accumulated_ += scale_ * (slow_ ? seconds * kSlowMotion : seconds);
    Tick ticks = static_cast<Tick>(std::min(accumulated_ / kTickSeconds, double(kMostTicks)));
    accumulated_ -= double(ticks) * kTickSeconds;
    if (ticks == kMostTicks) accumulated_ = std::min(accumulated_, 0.0);
    accumulated_ = std::clamp(accumulated_, 0.0, kTickSeconds);
    return ticks;
}

}  // namespace kerf::sim
