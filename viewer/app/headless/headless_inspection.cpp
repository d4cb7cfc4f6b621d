#include "viewer/app/headless/headless_inspection.h"

#include <iostream>
#include <optional>

#include "viewer/app/headless/run_length.h"
#include "viewer/app/inspect/inspection.h"
#include "viewer/app/main_loop.h"
#include "viewer/app/run_report.h"
#include "viewer/render/offscreen_context.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

/// One run with one back end.
class HeadlessInspection : public Program
{
public:
    /// @param messages  what the run says goes to its end
    HeadlessInspection(const Options& options, const RunSetup& setup, const std::string& backend,
                       std::vector<std::string>& messages)
        : view_(options.view),
          waits_(options.waits),
          painter_(options.width, options.height),
          inspection_(setup, with_backend(setup.settings, backend), options.autopilot, painter_),
          messages_(messages)
    {
        if (!waits_) painter_.warm_up(*setup.models, inspection_.simulation().scene().most_pieces());
        if (view_.panel || view_.help || inspection_.game() != nullptr) interface_.emplace(view_.ui_scale);
    }

    void advance(const Frame& frame) override
    {
        inspection_.advance(sim::kTicksPerFrame, {}, waits_ && frame.pace == Pace::fixed_step);
        if (std::string message = inspection_.simulation().take_message(); !message.empty()) say(std::move(message));
    }

    void sync() override
    {
        inspection_.sync();
        say_images();
    }

    void draw(const Frame&, const glm::ivec2& size) override
    {
        inspection_.paint(view_, true);
        say_images();
        if (interface_) write(size);
    }

    void take_frame_time(double ms) override
    {
        inspection_.add_frame_time(ms);
        inspection_.add_frame(ms);
    }
    const render::FrameTarget& picture() const override { return painter_.target(); }

    const Inspection& inspection() const { return inspection_; }

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
    /// That some could not be used.
    void say_images()
    {
        for (std::string& message : painter_.take_messages()) say(std::move(message));
    }

    void write(const glm::ivec2& size)
    {
        inspection_.use_letters(*interface_, size);
        PanelState state = inspection_.panel(view_, {});
        // Windows find their sizes in the first frame, and are seen in the second.
        for (int pass = has_written_ ? 1 : 0; pass < 2; ++pass) {
            interface_->begin(size.x, size.y, 1.0 / 60.0);
            inspection_.write(*interface_, size, state);
            pass == 0 ? interface_->skip() : interface_->draw();
        }
        has_written_ = true;
    }

    ViewSettings view_;
    bool waits_;  ///< for what threads make
    Painter painter_;
    Inspection inspection_;
    std::optional<UserInterface> interface_;
    bool has_written_ = false;
    std::vector<std::string>& messages_;
};

}  // namespace

int run_headless_inspection(const Options& options)
{
    const RunSetup setup = read_run_setup(options);
    for (const std::string& message : setup.messages) std::cerr << "kerf-viewer: " << message << "\n";
    const render::OffscreenContext context;
    render::GlErrorLog errors;

    std::vector<std::string> backends = options.backends;
    if (backends.empty()) backends.push_back(setup.settings.backend);
    const LoopPlan plan{Pace::fixed_step, frames_of(options, setup.script), options.draw_every, options.screenshot,
                        options.record};
    OffscreenDisplay display({options.width, options.height});
    Json runs = Json::array();
    std::vector<std::string> messages = setup.messages;
    for (const std::string& backend : backends) {
        HeadlessInspection run(options, setup, backend, messages);
        MainLoop(run, display, errors, plan).run();
        if (!options.save_script.empty())
            sim::write_script(options.save_script, run.inspection().simulation().recording());
        runs.push_back(run.inspection().report());
    }

    Json report = report_head({options.width, options.height}, errors);
    report["messages"] = messages;
    report["runs"] = std::move(runs);
    std::cout << report.dump(2) << "\n";
    return finish_run(errors);
}

}  // namespace kerf::app
