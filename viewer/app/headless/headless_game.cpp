#include "viewer/app/headless/headless_game.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "common/stopwatch.h"
#include "viewer/app/exit_status.h"
#include "viewer/app/game/game_flow.h"
#include "viewer/app/headless/run_length.h"
#include "viewer/app/hexadecimal.h"
#include "viewer/app/session.h"
#include "viewer/app/user_interface.h"
#include "viewer/render/gl_error_log.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/script.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

Json report_of(const sim::Simulation& simulation)
{
    return {{"scene", simulation.scene().name()},   {"backend", simulation.backend()},
            {"proxy", name_of(simulation.proxy())}, {"ticks", simulation.now()},
            {"cuts", simulation.cuts().size()},     {"state_hash", hexadecimal(simulation.state_hash())}};
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

}  // namespace

int run_headless_game(const Options& options)
{
    const render::OffscreenContext context;
    render::GlErrorLog errors;
    Painter painter(options.width, options.height);
    UserInterface interface(1.0f);
    sound::Speaker speaker = sound::Speaker::silent();

    sim::Script script;
    if (!options.script.empty()) script = sim::read_script(options.script);
    const GameSetup setup = setup_of(options, script);
    GameFlow flow(setup, painter, speaker);
    refuse_to_replace(options, flow.models());
    flow.push(script.events);
    game::Autopilot autopilot(setup.seed);
    const std::int64_t frames = frames_of(options, script);
    std::optional<render::Recording> recording;
    if (!options.record.empty()) recording.emplace(options.record);

    Stopwatch frame_time;
    for (std::int64_t frame = 0; frame < frames; ++frame) {
        const bool is_last = frame + 1 == frames;
        if (is_last && !options.screen.empty()) flow.show_screen(*ui::find_screen(options.screen));
        if (options.autopilot) flow.let_play(autopilot);
        // What a frame took is shown by the giant's panel; the simulation goes in fixed steps.
        flow.advance(1e-3 * frame_time.lap());
        const bool is_wanted = recording || (is_last && !options.screenshot.empty()) ||
                               (options.draw_every > 0 && frame % options.draw_every == 0);
        if (!is_wanted) {
            flow.sync();
            continue;
        }
        flow.paint(options.view);
        interface.use_game_letters(options.width, options.height);
        interface.begin(options.width, options.height, 1.0 / 60.0);
        ui::Canvas canvas(interface.letters(), {options.width, options.height});
        flow.write(canvas);
        interface.draw();
        if (recording) recording->add(painter.target().read());
        if (is_last && !options.screenshot.empty()) render::write_png(options.screenshot, painter.target().read());
    }
    if (!options.save_script.empty()) sim::write_script(options.save_script, flow.simulation()->recording());
    errors.check();
    Json report{{"version", KERF_VERSION},     {"graphics", render::describe_current_context()},
                {"width", options.width},      {"height", options.height},
                {"gl_errors", errors.count()}, {"gl_messages", errors.messages()},
                {"scene", flow.scene()},       {"screen", ui::screen_names()[std::size_t(flow.screens().screen())]}};
    if (flow.duel() != nullptr)
        report["halves"] = report_of(*flow.duel());
    else
        report["runs"] = Json::array({report_of(*flow.simulation())});
    std::cout << report.dump(2) << "\n";
    for (const std::string& message : errors.messages()) std::cerr << "kerf-viewer: GL: " << message << "\n";
    return errors.count() == 0 ? kDone : kUnusable;
}

}  // namespace kerf::app
