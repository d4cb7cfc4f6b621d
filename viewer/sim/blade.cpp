#include "viewer/sim/blade.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace kerf::sim {
namespace {

/// Older parts of the path say nothing about the stroke's direction any more.
constexpr Microseconds kChordWindow = 250'000;
static_assert(kChordWindow >= kSpeedWindow && kChordWindow >= kTrail);

}  // namespace

std::string_view name_of(Gesture gesture)
{
    return gesture == Gesture::blade ? "blade" : "segment";
}

void Blade::press(Microseconds time, const glm::dvec2& position)
{
    pressed_ = true;
    ++swipe_;
    pressed_at_ = {time, swipe_, position};
    path_.assign(1, pressed_at_);
    travelled_.assign(1, 0.0);
    corners_.assign(1, pressed_at_);
}

std::optional<BladeSegment> Blade::move(Microseconds time, const glm::dvec2& position)
{
    return extend(time, position, false);
}

std::optional<BladeSegment> Blade::release(Microseconds time, const glm::dvec2& position)
{
    const std::optional<BladeSegment> segment = extend(time, position, true);
    pressed_ = false;
    return segment;
}

std::optional<BladeSegment> Blade::extend(Microseconds time, const glm::dvec2& position, bool last)
{
    if (!pressed_) return std::nullopt;
    travelled_.push_back(travelled_.back() + glm::distance(path_.back().position, position));
    path_.push_back({time, swipe_, position});
    // The sample before the window is kept: the path enters the window on the way from it.
    while (path_.size() > 2 && path_[1].time < time - kChordWindow) {
        path_.pop_front();
        travelled_.pop_front();
    }
    while (corners_.size() > 1 && corners_.front().time < time - kChordWindow) corners_.pop_front();

    if (gesture_ == Gesture::segment) {
        if (!last || glm::distance(pressed_at_.position, position) < kShortestSegment) return std::nullopt;
        return BladeSegment{swipe_, pressed_at_.position, position, pressed_at_.position, speed(time)};
    }

    BladeSegment segment{swipe_, corners_.back().position, position, position, speed(time)};
    const double length = glm::distance(segment.from, segment.to);
    if (!(length > 0.0) || (length < kShortestSegment && !last)) return std::nullopt;
    for (auto corner = corners_.rbegin(); corner != corners_.rend(); ++corner) {
        segment.base = corner->position;
        if (glm::distance(segment.base, position) >= kChord) break;
    }
    corners_.push_back({time, swipe_, position});
    if (segment.speed < kSlowestCut || glm::distance(segment.base, position) < kShortestSegment) return std::nullopt;
    return segment;
}

double Blade::speed(Microseconds time) const
{
    const Microseconds start = time - kSpeedWindow;
    const auto samples_until = [this](Microseconds t) {
        const auto later = [](Microseconds wanted, const TrailPoint& point) { return wanted < point.time; };
        return std::size_t(std::upper_bound(path_.begin(), path_.end(), t, later) - path_.begin());
    };
    const std::size_t first = std::max<std::size_t>(samples_until(start), 1), end = samples_until(time);
    double length = 0.0;
    if (first < end) {
        // The path enters the window on the way from the sample before the first.
        const TrailPoint &a = path_[first - 1], &b = path_[first];
        const double entering = travelled_[first] - travelled_[first - 1];
        const double share =
            a.time >= start ? 1.0 : double(b.time - start) / double(std::max<Microseconds>(b.time - a.time, 1));
        length = share * entering + (travelled_[end - 1] - travelled_[first]);
    }
    // A swipe that has just begun: over the time it took, but at least a tick.
    const Microseconds elapsed = std::clamp(time - pressed_at_.time, time_of(1), kSpeedWindow);
    return length / (double(elapsed) * 1e-6);
}

std::vector<TrailPoint> Blade::trail(Microseconds now) const
{
    std::vector<TrailPoint> points;
    if (path_.empty()) return points;
    if (gesture_ == Gesture::segment) {
        if (pressed_ || path_.back().time >= now - kTrail) points = {pressed_at_, path_.back()};
        return points;
    }
    for (const TrailPoint& point : path_)
        if (point.time >= now - kTrail) points.push_back(point);
    return points;
}

void Blade::hash(StateHash& hash) const
{
    hash.add(std::uint64_t(gesture_));
    hash.add(pressed_);
    hash.add(swipe_);
    const auto add = [&](const TrailPoint& point) {
        hash.add(point.time);
        hash.add(point.position.x);
        hash.add(point.position.y);
    };
    add(pressed_at_);
    for (const TrailPoint& point : path_) add(point);
    for (const TrailPoint& corner : corners_) add(corner);
}

}  // namespace kerf::sim
