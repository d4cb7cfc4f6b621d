#pragma once

#include <memory>

#include "viewer/app/game/round.h"
#include "viewer/app/soundtrack.h"
#include "viewer/effects/effects.h"
#include "viewer/sim/simulation.h"
#include "viewer/sound/speaker.h"

namespace kerf::app {

/// What a round of one simulation is begun with.
struct RoundSetup
{
    std::shared_ptr<sim::ModelLibrary> models;
    sim::Settings settings;
    std::unique_ptr<sim::Scene> scene;
    bool fixed_step = false;
};

/// A round of one simulation, seen and heard. On its own it shows any scene.
class SimulatedRound : public Round
{
public:
    /// @param speaker  outlives it
    SimulatedRound(RoundSetup setup, sound::Speaker& speaker);

    sim::Tick now() const override { return simulation_.now(); }
    void push(const std::vector<sim::InputEvent>& events) override { simulation_.push(events); }
    void let_play(game::Autopilot& autopilot) override { push(autopilot.play(simulation_)); }
    std::string take_message() override { return simulation_.take_message(); }
    void sync(Painter& painter) override { painter.sync(simulation_); }
    void paint(Painter& painter, const ViewSettings& view) override;
    const sim::Simulation* simulation() const override { return &simulation_; }
    std::vector<std::size_t> next_models() const override { return simulation_.scene().next_models(); }

protected:
    double time_scale() const override;
    void go_on(sim::Tick ticks, const std::vector<sim::InputEvent>& events, const RoundFrame& frame) override;
    void let_go() override;
    void write_stage(ui::Canvas& canvas, const RoundText& text) override;

    /// After each batch of ticks.
    virtual void watch(const RoundFrame& /*frame*/) {}
    /// What is written over the stage and its effects.
    virtual void write_display(ui::Canvas& /*canvas*/, const RoundText& /*text*/) {}

    sim::Simulation& played() { return simulation_; }
    sound::Speaker& speaker() { return speaker_; }

private:
    sim::Simulation simulation_;
    sound::Speaker& speaker_;
    effects::Effects effects_;
    Soundtrack soundtrack_;
};

}  // namespace kerf::app
