#include "viewer/ui/keyboard_blade.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kerf::ui {

void KeyboardBlade::hold(BladeKey key, bool is_down)
{
    held_[static_cast<std::size_t>(key)] = is_down;
    if (is_down) is_shown_ = true;
}

void KeyboardBlade::let_go()
{
    held_.fill(false);
    is_cutting_ = false;
    moving_for_ = 0.0;
}

void KeyboardBlade::put_away()
{
    let_go();
    is_shown_ = false;
}

std::vector<sim::PointerChange> KeyboardBlade::advance(double seconds, const glm::dvec2& reach)
{
    using Kind = sim::PointerChange::Kind;
    std::vector<sim::PointerChange> changes;
    if (!is_shown_) return changes;
    const bool wants_cut = holds(BladeKey::cut);
    if (wants_cut && !is_cutting_) changes.push_back({Kind::press, place_});

    const auto step = [&](BladeKey more, BladeKey less) { return double(holds(more)) - double(holds(less)); };
    const glm::dvec2 direction(step(BladeKey::right, BladeKey::left), step(BladeKey::up, BladeKey::down));
    const glm::dvec2 before = place_;
    if (direction == glm::dvec2(0.0)) {
        moving_for_ = 0.0;
    } else {
        moving_for_ += seconds;
        const double share = std::min(moving_for_ / kGathering, 1.0);
        place_ += glm::mix(kStartSpeed, kFullSpeed, share) * seconds * glm::normalize(direction);
    }
    place_ = glm::clamp(place_, -reach, reach);
    if (place_ != before && (wants_cut || is_cutting_)) changes.push_back({Kind::move, place_});
    if (!wants_cut && is_cutting_) changes.push_back({Kind::release, place_});
    is_cutting_ = wants_cut;
    return changes;
}

}  // namespace kerf::ui
