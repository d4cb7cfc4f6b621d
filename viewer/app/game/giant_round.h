#pragma once

#include "viewer/app/game/giant_controls.h"
#include "viewer/app/game/simulated_round.h"

namespace kerf::app {

/// The scene `giant`: cuts of a mesh as large as one likes, and what they cost.
class GiantRound : public SimulatedRound
{
public:
    /// @param setup      with a game::GiantScene
    /// @param triangles  of the first giant
    /// @param frames     how long frames took; outlives it
    GiantRound(RoundSetup setup, std::int64_t triangles, const FrameStatistics& frames, sound::Speaker& speaker)
        : SimulatedRound(std::move(setup), speaker), controls_(played(), frames)
    {
        played().command("size " + std::to_string(triangles));
    }

    GiantControls* giant() override { return &controls_; }

protected:
    void watch(const RoundFrame&) override { controls_.follow(); }
    void let_go() override
    {
        SimulatedRound::let_go();
        controls_.let_go();
    }
    void write_display(ui::Canvas& canvas, const RoundText& text) override
    {
        controls_.write(canvas, text.pointer, text.arriving);
    }

private:
    GiantControls controls_;
};

}  // namespace kerf::app
