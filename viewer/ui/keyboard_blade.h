#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "viewer/sim/pointer_sampler.h"

namespace kerf::ui {

/// What the keys of the blade do.
enum class BladeKey : std::size_t
{
    up,
    down,
    left,
    right,
    cut,
};
inline constexpr std::size_t kBladeKeys = 5;

/// A pointer for who has no mouse: keys that are held move a cross over the stage, and while the key `cut` is held it
/// cuts. What it does is told as a pointer's changes, so that it goes the same way as a swipe of the mouse.
class KeyboardBlade
{
public:
    /// Speeds of the cross, m/s on the stage: where it starts, so that it can be placed, and where it comes to, so that
    /// a swipe feels like one. Both are faster than sim::kSlowestCut.
    static constexpr double kStartSpeed = 4.5, kFullSpeed = 15.0;
    /// Time between them, seconds.
    static constexpr double kGathering = 0.3;

    /// A key goes down or up.
    void hold(BladeKey key, bool is_down);
    /// Every key counts as released, until it is pressed again; the swipe is forgotten: whoever holds the game ends it.
    void let_go();
    /// The cross is no longer shown: the player has taken the mouse.
    void put_away();

    /// What it does in `seconds`, in order. @param reach  the stage's part that is seen: half its size, metres
    std::vector<sim::PointerChange> advance(double seconds, const glm::dvec2& reach);

    /// The cross has been used, and not been put away.
    bool is_shown() const { return is_shown_; }
    bool is_cutting() const { return is_cutting_; }
    /// Stage coordinates.
    const glm::dvec2& place() const { return place_; }

private:
    bool holds(BladeKey key) const { return held_[static_cast<std::size_t>(key)]; }

    std::array<bool, kBladeKeys> held_{};
    bool is_shown_ = false, is_cutting_ = false;
    glm::dvec2 place_{0.0};
    double moving_for_ = 0.0;  ///< seconds
};

}  // namespace kerf::ui
