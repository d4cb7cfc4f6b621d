#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "viewer/app/game/stage_layout.h"
#include "viewer/app/window.h"
#include "viewer/sim/pointer_sampler.h"
#include "viewer/ui/canvas.h"
#include "viewer/ui/keyboard_blade.h"

namespace kerf::app {

/// What mouse and keyboard do to the blade, in pixels and keys, as input for a simulation. They take turns: the mouse
/// puts the keyboard's cross away, and no key counts during a swipe of the mouse.
class BladeInput
{
public:
    explicit BladeInput(const StageLayout& layout) : layout_(layout) {}

    /// A key goes down or up.
    void hold(ui::BladeKey key, bool is_down);
    /// @param change  pixels of a picture of this size
    void point(const WindowPointer& change, const glm::vec2& size);
    /// What the keys do in `seconds`. @param size  of the picture: the cross stays on it
    void steer(double seconds, const glm::vec2& size);
    /// Nothing is to be cut now: a swipe of the keyboard ends, and its keys count as released.
    void release_keys();
    /// The game stands still from now on: every swipe ends where it is, and what waits is dropped.
    void let_go();

    /// What has been done since the last call, for the ticks of (start, end].
    std::vector<sim::InputEvent> take(sim::Microseconds start, sim::Microseconds end);

    /// The mouse's button is down.
    bool is_swiping() const { return is_swiping_; }
    const ui::KeyboardBlade& keyboard() const { return keyboard_; }
    const StageLayout& layout() const { return layout_; }

    /// Shows where the keyboard's blade is, on every stage; nothing before it was used.
    void write(ui::Canvas& canvas) const;

private:
    StageLayout layout_;
    sim::PointerSampler sampler_;
    std::vector<sim::PointerChange> changes_;  ///< since the last take()
    ui::KeyboardBlade keyboard_;
    bool is_swiping_ = false;
    std::size_t stage_ = 0;  ///< where the swipe began, and where its places are read
};

}  // namespace kerf::app
