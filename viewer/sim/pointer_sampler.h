#pragma once

#include <optional>
#include <span>
#include <vector>

#include "viewer/sim/script.h"

namespace kerf::sim {

/// What a window reports in one frame, in order, without a time.
struct PointerChange
{
    enum class Kind : std::uint8_t
    {
        press,
        move,
        release
    } kind = Kind::move;
    glm::dvec2 position{0.0};  ///< stage coordinates
};

/// Windows deliver the pointer's movement frame by frame without saying when it happened. The sampler spreads a frame's
/// path evenly over the frame's interval and adds a sample where a tick ends, so that a long frame gives the blade as
/// many samples as several short ones: a steady swipe is the same at 10, 30 and 120 frames per second.
class PointerSampler
{
public:
    /// Events for the frame (start, end], times in simulation time. A frame without time (paused, or shorter than a
    /// tick) gives none, and its changes belong to the next. O(changes + ticks).
    std::vector<InputEvent> frame(Microseconds start, Microseconds end, std::span<const PointerChange> changes);

    /// The pointer is not followed for a while: what waits is dropped, and a swipe under way ends where it was at the
    /// start of the next frame.
    void let_go();

private:
    std::vector<PointerChange> waiting_;  ///< of frames without time
    std::optional<glm::dvec2> position_;  ///< the last one seen
    bool pressed_ = false;
};

}  // namespace kerf::sim
