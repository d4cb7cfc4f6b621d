#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "viewer/duel/half.h"

namespace kerf::duel {

/// How a half of a duel stands. Milliseconds on the clock.
struct Score
{
    std::string backend;
    std::size_t cuts = 0;   ///< that went through
    double cut_ms = 0.0;    ///< all of them, from hit to pieces
    double worst_ms = 0.0;  ///< the longest
    double last_ms = 0.0;
    double worst_frame_ms = 0.0;   ///< the most that the cuts of one frame took
    std::int64_t lost_frames = 0;  ///< whole frames of 1/60 s that went by during cuts
    double behind_ms = 0.0;        ///< how much later than the clock of the duel this half is
};

/// What makes a scene for a half.
using SceneMaker = std::function<std::unique_ptr<sim::Scene>()>;

/// Two back ends side by side on the same throws and the same swipes. Each half has its own simulation and its own
/// thread: a slow cut freezes its own half only, which then catches up at kCatchUp times the speed. What either half
/// does follows from seed and input, however slow it was.
class Duel
{
public:
    static constexpr sim::Tick kCatchUp = 3;

    /// @param settings  of both; the back ends are named by `backends`
    /// @throws std::invalid_argument  as Simulation
    Duel(const std::shared_ptr<sim::ModelLibrary>& models, const sim::Settings& settings,
         const std::array<std::string, 2>& backends, const SceneMaker& make_scene);

    /// The duel's clock goes on by so many ticks, in which this input happened. Returns at once.
    void advance(sim::Tick ticks, const std::vector<sim::InputEvent>& events);
    /// Waits until both halves have done what they can in this frame, but no longer than this.
    void wait_for(std::chrono::microseconds longest);
    /// Waits until both halves have caught up with the clock: for runs in fixed steps.
    void finish();

    sim::Tick now() const { return now_; }
    sim::Microseconds time() const { return sim::time_of(now_); }

    /// The blade as the player moves it, whatever the halves are doing.
    const sim::Blade& blade() const { return blade_; }

    Half& half(std::size_t i) { return *halves_[i]; }
    /// Of the last time that the half was idle, but for `behind_ms`, which is of now.
    Score score(std::size_t i);

private:
    void follow(const sim::InputEvent& event);
    void count(std::size_t i, const sim::CutRecord& cut);

    std::array<std::unique_ptr<Half>, 2> halves_;
    std::array<Score, 2> scores_;
    std::array<std::size_t, 2> counted_{};  ///< cut records that are in the score
    std::array<std::int64_t, 2> frame_{};   ///< of the last of them
    std::array<double, 2> frame_ms_{};      ///< what the cuts of that frame took so far
    sim::Blade blade_;
    sim::Tick now_ = 0;
};

}  // namespace kerf::duel
