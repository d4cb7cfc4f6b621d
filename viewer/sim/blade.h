#pragma once

#include <cstdint>
#include <deque>
#include <glm/vec2.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "viewer/sim/state_hash.h"
#include "viewer/sim/ticks.h"

namespace kerf::sim {

/// What cuts: the moving pointer, or, as in the report's program, the segment from press to release.
enum class Gesture : std::uint8_t
{
    blade,    ///< every segment of a swipe that is fast enough cuts at once
    segment,  ///< one cut on release, along the straight line from where the button was pressed
};
std::string_view name_of(Gesture gesture);

/// Slower movement does not cut, m/s on the stage: a fifth of the stage's width in a second.
inline constexpr double kSlowestCut = 3.0;
/// Time over which the path length is taken for the speed: several events of any mouse or display.
inline constexpr Microseconds kSpeedWindow = 50'000;
/// Movement shorter than this is gathered until it is longer, metres: two pixels at 1280x720.
inline constexpr double kShortestSegment = 0.02;
/// The cutting plane's direction is taken from so much of the path, metres: at 36 pixels of 1280x720 a pixel more or
/// less turns the plane by less than two degrees.
inline constexpr double kChord = 0.4;
/// How long the path stays visible.
inline constexpr Microseconds kTrail = 120'000;

/// A piece of a swipe that is tested against the objects' proxies. Stage coordinates.
struct BladeSegment
{
    std::uint32_t swipe = 0;  ///< counts up from 1 with each press
    glm::dvec2 from{0.0}, to{0.0};
    glm::dvec2 base{0.0};  ///< the cutting plane goes through the eye, `base` and `to`
    double speed = 0.0;    ///< m/s
};

/// A point of the path.
struct TrailPoint
{
    Microseconds time = 0;
    std::uint32_t swipe = 0;
    glm::dvec2 position{0.0};
};

/// Turns timed pointer samples into segments that cut. Only the samples' own times and places count, not how they were
/// grouped into frames: the same swipe at 10, 30 or 120 frames per second gives the same segments, bit for bit.
class Blade
{
public:
    void set_gesture(Gesture gesture) { gesture_ = gesture; }
    Gesture gesture() const { return gesture_; }

    /// Times must not decrease. Each gives the segment that it completes, if it does.
    void press(Microseconds time, const glm::dvec2& position);
    std::optional<BladeSegment> move(Microseconds time, const glm::dvec2& position);
    std::optional<BladeSegment> release(Microseconds time, const glm::dvec2& position);

    bool pressed() const { return pressed_; }
    /// The swipe under way or the last one; 0 before the first.
    std::uint32_t swipe() const { return swipe_; }
    /// Path length over the last kSpeedWindow up to `time`, m/s. O(log samples kept).
    double speed(Microseconds time) const;

    /// Oldest first, at most kTrail before `now`: for drawing. With the gesture `segment` press point and pointer.
    std::vector<TrailPoint> trail(Microseconds now) const;

    /// Points that are kept: bounded by time, however long a swipe lasts.
    std::size_t remembered() const { return path_.size() + corners_.size(); }
    void hash(StateHash& hash) const;

private:
    std::optional<BladeSegment> extend(Microseconds time, const glm::dvec2& position, bool last);

    Gesture gesture_ = Gesture::blade;
    bool pressed_ = false;
    std::uint32_t swipe_ = 0;
    TrailPoint pressed_at_;
    std::deque<TrailPoint> path_;     ///< the latest samples of this swipe
    std::deque<double> travelled_;    ///< from the press to each of them, metres
    std::deque<TrailPoint> corners_;  ///< the latest ends of segments of this swipe
};

}  // namespace kerf::sim
