#include "viewer/app/headless/headless_game.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "viewer/app/game/game_flow.h"
#include "viewer/app/headless/run_length.h"
#include "viewer/app/hexadecimal.h"
#include "viewer/app/main_loop.h"
#include "viewer/app/run_report.h"
#include "viewer/app/run_setup.h"
#include "viewer/app/user_interface.h"
#include "viewer/render/gl_error_log.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/body_proxies.h"
#include "viewer/sim/script.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

Json report_of(const sim::Simulation& simulation)
{
    return {{"scene", simulation.scene().name()},
            {"backend", simulation.backend()},
            {"proxy", sim::proxy_name(simulation.proxy())},
            {"ticks", simulation.now()},
            {"cuts", simulation.cuts().size()},
            {"state_hash", hexadecimal(simulation.state_hash())}};
}

Json report_of(DuelView& view)
{
    Json halves = Json::array();
    for (std::size_t i = 0; i < 2; ++i) {
        Json half = report_of(view.duel().half(i).simulation());
        const duel::Score score = view.duel().score(i);
        half["cut_ms"] = score.cut_ms;
        half["longest_cut_ms"] = score.worst_ms;
        half["worst_frame_ms"] = score.worst_frame_ms;
        half["lost_frames"] = score.lost_frames;
        halves.push_back(std::move(half));
    }
    return halves;
}

GameSetup setup_of(const Options& options, const sim::Script& script)
{
    const sim::Settings said = settings_of(options, script, "menu");
    if (said.record && (said.scene == "menu" || said.scene == "duel"))
        throw std::invalid_argument("menu and duel are not recorded");
    GameSetup setup;
    setup.data_folder = options.data_folder;
    setup.scene = said.scene;
    setup.backend = said.backend;
    setup.proxy = said.proxy;
    setup.seed = said.seed;
    setup.record = said.record;
    if (said.scene == "duel") setup.duelists = options.backends;
    if (setup.duelists.empty() && said.scene == "duel" && !said.backend.empty()) setup.duelists = {said.backend};
    setup.fixed_step = true;
    setup.giant = options.giant;
    if (options.boulder > 0) setup.boulder = options.boulder;
    return setup;
}

/// The game in fixed steps, which nobody sees.
class HeadlessGame : public Program
{
public:
    HeadlessGame(const Options& options, const GameSetup& setup, const sim::Script& script)
        : options_(options),
          painter_(options.width, options.height),
          flow_(setup, painter_, speaker_),
          autopilot_(setup.seed)
    {
        refuse_to_replace(options, flow_.models());
        flow_.push(script.events);
    }

    void advance(const Frame& frame) override
    {
        if (frame.is_last && !options_.screen.empty()) flow_.show_screen(*ui::find_screen(options_.screen));
        if (options_.autopilot) flow_.let_play(autopilot_);
        flow_.advance(frame.seconds);
    }
    void sync() override { flow_.sync(); }
    void draw(const Frame&, const glm::ivec2& size) override
    {
        flow_.paint(options_.view);
        interface_.use_game_letters(size.x, size.y);
        interface_.begin(size.x, size.y, 1.0 / 60.0);
        ui::Canvas canvas(interface_.letters(), size);
        flow_.write(canvas);
        interface_.draw();
    }
    const render::FrameTarget& picture() const override { return painter_.target(); }

    GameFlow& flow() { return flow_; }

private:
    const Options& options_;
    Painter painter_;
    UserInterface interface_{1.0f};
    sound::Speaker speaker_ = sound::Speaker::silent();
    GameFlow flow_;
    game::Autopilot autopilot_;
};

}  // namespace

int run_headless_game(const Options& options)
{
    const render::OffscreenContext context;
    render::GlErrorLog errors;
    sim::Script script;
    if (!options.script.empty()) script = sim::read_script(options.script);
    HeadlessGame game(options, setup_of(options, script), script);
    OffscreenDisplay display({options.width, options.height});
    MainLoop(game, display, errors,
             {Pace::fixed_step, frames_of(options, script), options.draw_every, options.screenshot, options.record})
        .run();

    GameFlow& flow = game.flow();
    if (!options.save_script.empty()) sim::write_script(options.save_script, flow.simulation()->recording());
    Json report = report_head({options.width, options.height}, errors);
    report["scene"] = flow.scene();
    report["screen"] = ui::screen_names()[std::size_t(flow.screens().screen())];
    if (flow.duel() != nullptr)
        report["halves"] = report_of(*flow.duel());
    else
        report["runs"] = Json::array({report_of(*flow.simulation())});
    std::cout << report.dump(2) << "\n";
    return finish_run(errors);
}

}  // namespace kerf::app
