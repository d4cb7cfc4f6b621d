#include "viewer/app/headless/headless.h"

#include <iostream>
#include <optional>

#include "common/cpu_stopwatch.h"
#include "common/stopwatch.h"
#include "viewer/app/exit_status.h"
#include "viewer/app/headless/run_length.h"
#include "viewer/app/inspect/game_overlay.h"
#include "viewer/app/inspect/panel.h"
#include "viewer/app/inspect/run_report.h"
#include "viewer/app/painter.h"
#include "viewer/app/session.h"
#include "viewer/app/user_interface.h"
#include "viewer/game/autopilot.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/model_preparer.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

/// One run with one back end.
class HeadlessRun
{
public:
    /// @param messages  what the run says goes to its end
    HeadlessRun(const Options& options, const Session& session, const std::string& backend,
                std::vector<std::string>& messages)
        : options_(options),
          frames_(frames_of(options, session.script)),
          simulation_(session.models, with_backend(session.settings, backend), session.make_scene()),
          preparer_(session.models),
          painter_(options.width, options.height),
          autopilot_(session.settings.seed),
          messages_(messages)
    {
        if (!options.record.empty()) recording_.emplace(options.record);
        if (options.view.panel || options.view.help || game::game_of(simulation_.scene()) != nullptr)
            interface_.emplace(options.view.ui_scale);
        simulation_.push(session.script.events);
    }

    Json play()
    {
        for (std::int64_t frame = 0; frame < frames_; ++frame) {
            Stopwatch whole;
            preparer_.want(simulation_.scene().next_models(), simulation_.backend(), simulation_.proxy());
            preparer_.finish();
            const double checks = simulation_.check_cpu_ms();
            CpuStopwatch simulate;
            if (options_.autopilot) simulation_.push(autopilot_.play(simulation_));
            simulation_.advance(sim::kTicksPerFrame);
            times_.simulate_cpu_ms.push_back(1e3 * simulate.lap() - (simulation_.check_cpu_ms() - checks));
            if (std::string message = simulation_.take_message(); !message.empty()) say(std::move(message));

            effects_.follow(simulation_);
            CpuStopwatch submit;
            painter_.sync(simulation_);
            for (std::string& message : painter_.take_messages()) say(std::move(message));
            if (wants_picture(frame)) {
                painter_.paint(simulation_, options_.view, 1.0, &effects_);
                times_.submit_cpu_ms.push_back(1e3 * submit.lap());
                finish_picture(frame);
                times_.frame_ms.push_back(whole.lap());
                statistics_.add(times_.frame_ms.back());
            }
        }
        if (!options_.save_script.empty()) sim::write_script(options_.save_script, simulation_.recording());
        return report_of(simulation_, painter_.world(), times_);
    }

private:
    static sim::Settings with_backend(sim::Settings settings, const std::string& backend)
    {
        settings.backend = backend;
        settings.hash_surfaces = true;
        return settings;
    }

    void say(std::string message)
    {
        std::cerr << "kerf-viewer: " << message << "\n";
        messages_.push_back(std::move(message));
    }

    bool is_last(std::int64_t frame) const { return frame + 1 == frames_; }

    bool wants_picture(std::int64_t frame) const
    {
        if (recording_ || (is_last(frame) && !options_.screenshot.empty())) return true;
        return options_.draw_every > 0 && frame % options_.draw_every == 0;
    }

    void finish_picture(std::int64_t frame)
    {
        if (interface_) {
            if (game::game_of(simulation_.scene()) != nullptr)
                interface_->use_game_letters(options_.width, options_.height);
            PanelState state{simulation_, painter_, statistics_, options_.view, {}};
            state.simulation_ms = times_.simulate_cpu_ms.back();
            const game::GameScene* const game = game::game_of(simulation_.scene());
            // Windows find their sizes in the first frame, and are seen in the second.
            for (int pass = has_shown_panel_ ? 1 : 0; pass < 2; ++pass) {
                interface_->begin(options_.width, options_.height, 1.0 / 60.0);
                show_panel(state);
                if (game != nullptr) show_game(*interface_, options_.width, options_.height, *game, effects_);
                pass == 0 ? interface_->skip() : interface_->draw();
            }
            has_shown_panel_ = true;
        }
        glFinish();
        if (recording_) recording_->add(painter_.target().read());
        if (is_last(frame) && !options_.screenshot.empty())
            render::write_png(options_.screenshot, painter_.target().read());
    }

    Options options_;
    std::int64_t frames_;
    sim::Simulation simulation_;
    sim::ModelPreparer preparer_;
    effects::Effects effects_;
    Painter painter_;
    game::Autopilot autopilot_;
    std::optional<render::Recording> recording_;
    std::optional<UserInterface> interface_;
    bool has_shown_panel_ = false;
    FrameStatistics statistics_;
    FrameTimes times_;
    std::vector<std::string>& messages_;
};

}  // namespace

int run_headless(const Options& options)
{
    const Session session = open_session(options);
    for (const std::string& message : session.messages) std::cerr << "kerf-viewer: " << message << "\n";
    const render::OffscreenContext context;
    render::GlErrorLog errors;

    std::vector<std::string> backends = options.backends;
    if (backends.empty()) backends.push_back(session.settings.backend);
    Json runs = Json::array();
    std::vector<std::string> messages = session.messages;
    for (const std::string& backend : backends) runs.push_back(HeadlessRun(options, session, backend, messages).play());

    errors.check();
    const Json report{{"version", KERF_VERSION},     {"graphics", render::describe_current_context()},
                      {"width", options.width},      {"height", options.height},
                      {"gl_errors", errors.count()}, {"gl_messages", errors.messages()},
                      {"messages", messages},        {"runs", std::move(runs)}};
    std::cout << report.dump(2) << "\n";
    for (const std::string& message : errors.messages()) std::cerr << "kerf-viewer: GL: " << message << "\n";
    return errors.count() == 0 ? kDone : kUnusable;
}

}  // namespace kerf::app
