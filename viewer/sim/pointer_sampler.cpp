#include "viewer/sim/pointer_sampler.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace kerf::sim {

std::vector<InputEvent> PointerSampler::frame(Microseconds start, Microseconds end,
                                              std::span<const PointerChange> changes)
{
    waiting_.insert(waiting_.end(), changes.begin(), changes.end());
    std::vector<InputEvent> events;
    if (end <= start || waiting_.empty()) return events;

    const glm::dvec2 first = position_.value_or(waiting_.front().position);
    double total = 0.0;
    glm::dvec2 previous = first;
    for (const PointerChange& change : waiting_) {
        total += glm::distance(previous, change.position);
        previous = change.position;
    }

    const auto emit = [&](Microseconds time, InputKind kind, const glm::dvec2& position) {
        events.push_back({time, kind, position, {}});
    };
    // When the pointer has come as far as `length` along the frame's path. A path without length happens at the end.
    const auto time_at = [&](double length) {
        const double share = total > 0.0 ? std::min(length / total, 1.0) : 1.0;
        return std::clamp(start + Microseconds(share * double(end - start)), start + 1, end);
    };

    double travelled = 0.0;
    Tick tick = tick_of(start + 1);
    previous = first;
    for (const PointerChange& change : waiting_) {
        const double length = glm::distance(previous, change.position);
        const Microseconds begin = travelled > 0.0 ? time_at(travelled) : start;
        travelled += length;
        const Microseconds time = time_at(travelled);
        for (; time_of(tick) < time; ++tick) {
            if (!pressed_ || time_of(tick) <= begin) continue;
            const double share = double(time_of(tick) - begin) / double(time - begin);
            emit(time_of(tick), InputKind::move, glm::mix(previous, change.position, share));
        }
        switch (change.kind) {
            case PointerChange::Kind::press:
                emit(time, InputKind::press, change.position);
                pressed_ = true;
                break;
            case PointerChange::Kind::move:
                if (pressed_) emit(time, InputKind::move, change.position);
                break;
            case PointerChange::Kind::release:
                if (pressed_) emit(time, InputKind::release, change.position);
                pressed_ = false;
                break;
        }
        previous = change.position;
    }
    position_ = previous;
    waiting_.clear();
    return events;
}

void PointerSampler::let_go()
{
    waiting_.clear();
    if (pressed_ && position_) waiting_.push_back({PointerChange::Kind::release, *position_});
}

}  // namespace kerf::sim
