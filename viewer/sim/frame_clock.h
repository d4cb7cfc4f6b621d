#pragma once

#include "viewer/sim/ticks.h"

namespace kerf::sim {

/// Real frame intervals in, whole ticks out: the accumulator of a fixed step, with pause, single step and slow motion.
class FrameClock
{
public:
    /// A frame never asks for more than this many ticks (a quarter of a second): after a hitch the simulation falls
    /// behind real time instead of trying to catch up.
    static constexpr Tick kMostTicks = kTicksPerSecond / 4;
    static constexpr double kSlowMotion = 0.2;

    /// Ticks to simulate for a frame that took `seconds`.
    Tick advance(double seconds);
    /// How far the present is behind the next tick, 0 to 1: for drawing between ticks.
    double fraction() const { return accumulated_ / kTickSeconds; }

    void set_paused(bool paused) { paused_ = paused; }
    bool paused() const { return paused_; }
    void set_slow_motion(bool slow) { slow_ = slow; }
    bool slow_motion() const { return slow_; }
    /// What Scene::time_scale() says; slow motion comes on top.
    void set_time_scale(double scale) { scale_ = scale; }
    /// While paused: the next advance() gives one frame's ticks.
    void step_once() { single_step_ = true; }

private:
    double scale_ = 1.0;
    double accumulated_ = 0.0;  ///< seconds of simulation time not yet simulated
    bool paused_ = false, slow_ = false, single_step_ = false;
};

}  // namespace kerf::sim
