#include "viewer/app/inside/inside_program.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <utility>

#include "common/files/file_error.h"
#include "common/support/median.h"
#include "viewer/app/inside/inside_panel.h"
#include "viewer/app/picture_name.h"
#include "viewer/app/run_report.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/back_ends.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

/// The program moves the plane to and fro once in so many frames, and turns it a little.
constexpr double kFramesToAndFro = 240.0;
constexpr double kFarthest = 0.26;  ///< half diagonals from the middle
/// Radians for each metre of the stage.
constexpr double kTurn = 0.35;

Json times_json(std::vector<double> times)
{
    if (times.empty()) return nullptr;
    const double worst = *std::ranges::max_element(times);
    return {{"median", core::median(std::move(times))}, {"max", worst}};
}

}  // namespace

InsideProgram::InsideProgram(const Options& options, const RunSetup& setup, Window* window)
    : models_(setup.models),
      settings_(options.view),
      moves_by_itself_(window == nullptr || options.autopilot || options.frames > 0),
      window_(window),
      view_(options.width, options.height),
      back_end_(setup.settings.backend.empty() ? sim::backend_names().front() : setup.settings.backend),
      messages_(setup.messages)
{
    if (window_ != nullptr) {
        window_->set_vsync(options.vsync);
        interface_.emplace(options.view.ui_scale * window_->content_scale(), window_->handle());
    } else if (settings_.panel || settings_.help) {
        interface_.emplace(options.view.ui_scale);
    }
    show_model(0);
}

/// The first model from there on that can be prepared.
void InsideProgram::show_model(std::size_t first)
{
    std::string why;
    for (std::size_t i = 0; i < models_->size(); ++i) {
        const std::size_t model = (first + i) % models_->size();
        why = models_->prepare(model, back_end_);
        if (!why.empty()) {
            say(models_->model(model).name + ": " + why);
            continue;
        }
        const bool shows_contours = study_ && study_->shows_contours();
        study_.reset();
        view_.forget();
        model_ = model;
        study_.emplace(models_->model(model).name, models_->make(model, back_end_));
        study_->show_contours(shows_contours);
        is_new_ = true;
        return;
    }
    throw core::io::FileError(why);
}

void InsideProgram::use_back_end(const std::string& name)
{
    back_end_ = name;
    const inside::MovingPlane plane = study_->plane();
    show_model(model_);
    study_->plane() = plane;
    say("back end " + back_end_);
}

void InsideProgram::advance(const Frame& frame)
{
    notice_.advance(frame.seconds);
    if (window_ != nullptr) {
        take_keys();
        take_pointer();
    }
    if (moves_by_itself_) move_by_itself(frame);
    update();
}

void InsideProgram::move_by_itself(const Frame& frame)
{
    const double turns = double(frame.number) / kFramesToAndFro;
    study_->plane().set_place(kFarthest * std::sin(2.0 * std::numbers::pi * turns));
    if (frame.number > 0) study_->plane().turn({0.004 * std::cos(2.0 * std::numbers::pi * turns), 0.0});
    // The second half of each round has contours.
    const bool wants_contours = turns - std::floor(turns) >= 0.5;
    if (wants_contours != study_->shows_contours()) study_->show_contours(wants_contours);
}

void InsideProgram::update()
{
    if (!study_->update()) return;
    is_new_ = true;
    section_ms_.push_back(study_->cost().cpu_ms);
    if (study_->section().status == Status::out_of_memory) say(study_->section().reason());
}

void InsideProgram::sync()
{
    view_.sync(*study_, models_->model(model_).images, is_new_);
    if (is_new_) upload_ms_.push_back(view_.upload_cpu_ms());
    is_new_ = false;
    for (std::string& message : view_.take_messages()) say(std::move(message));
}

void InsideProgram::draw(const Frame&, const glm::ivec2& size)
{
    view_.resize(size.x, size.y);
    sync();
    view_.paint(*study_, models_->model(model_).is_closed, settings_);
    if (!interface_) return;
    const InsidePanel panel{*study_, view_.upload_cpu_ms(), notice_.text()};
    if (window_ != nullptr) {
        interface_->begin();
        show_inside_panel(panel, settings_);
        interface_->draw();
        return;
    }
    // Windows find their sizes in the first frame, and are seen in the second.
    for (int pass = has_written_ ? 1 : 0; pass < 2; ++pass) {
        interface_->begin(size.x, size.y, 1.0 / 60.0);
        show_inside_panel(panel, settings_);
        pass == 0 ? interface_->skip() : interface_->draw();
    }
    has_written_ = true;
}

void InsideProgram::take_keys()
{
    for (const WindowKey& key : window_->take_keys())
        if (key.is_down && !interface_->wants_keyboard()) act(key.code);
}

void InsideProgram::act(int key)
{
    const std::vector<std::string>& names = sim::backend_names();
    switch (key) {
        case GLFW_KEY_C:
            return study_->show_contours(!study_->shows_contours());
        case GLFW_KEY_F:
            return study_->plane().flip();
        case GLFW_KEY_N:
            return show_model(model_ + 1);
        case GLFW_KEY_B: {
            const auto at = std::ranges::find(names, back_end_);
            return use_back_end(at == names.end() || at + 1 == names.end() ? names.front() : *(at + 1));
        }
        case GLFW_KEY_I:
            settings_.lighting = settings_.lighting == render::Lighting::textured ? render::Lighting::lambert
                                                                                  : render::Lighting::textured;
            return;
        case GLFW_KEY_W:
            settings_.wireframe = !settings_.wireframe;
            return;
        case GLFW_KEY_TAB:
            settings_.panel = !settings_.panel;
            return;
        case GLFW_KEY_H:
            settings_.help = !settings_.help;
            return;
        case GLFW_KEY_F12:
            return save_picture();
        case GLFW_KEY_F11:
            return window_->set_fullscreen(!window_->fullscreen());
        case GLFW_KEY_ESCAPE:
            return window_->close();
        default:
            return;
    }
}

/// Both buttons drag, which the window's own events do not tell apart.
void InsideProgram::take_pointer()
{
    window_->take_pointer();
    const glm::dvec2 size(window_->size());
    if (size.x < 1.0 || size.y < 1.0) return;
    const auto is_down = [&](int button) { return glfwGetMouseButton(window_->handle(), button) == GLFW_PRESS; };
    const bool left = is_down(GLFW_MOUSE_BUTTON_LEFT), right = is_down(GLFW_MOUSE_BUTTON_RIGHT);
    if ((!left && !right) || interface_->wants_mouse()) return pointer_.reset();
    glm::dvec2 pixel;
    glfwGetCursorPos(window_->handle(), &pixel.x, &pixel.y);
    const glm::dvec2 place = sim::Camera(size.x / size.y).screen_to_stage(pixel, size);
    const std::optional<glm::dvec2> before = std::exchange(pointer_, place);
    if (!before) return;
    const bool turns = right || glfwGetKey(window_->handle(), GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                       glfwGetKey(window_->handle(), GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
    if (turns)
        study_->plane().turn(kTurn * (place - *before));
    else
        study_->plane().move(InsideView::way_of(study_->plane(), *before, place));
}

/// Nobody loses his view over a full disk.
void InsideProgram::save_picture()
{
    const std::filesystem::path path = new_picture_name();
    try {
        render::write_png(path, view_.target().read());
        say("saved " + path.string());
    } catch (const core::io::FileError& error) {
        say(error.what());
    }
}

void InsideProgram::say(std::string message)
{
    messages_.push_back(message);
    notice_.say(std::move(message));
}

nlohmann::ordered_json InsideProgram::report() const
{
    const Section& section = study_->section();
    return {{"scene", "section"},
            {"model", study_->name()},
            {"backend", study_->object().back_end_name()},
            {"triangles", study_->object().triangle_count()},
            {"sections", section_ms_.size()},
            {"section_cpu_ms", times_json(section_ms_)},
            {"upload_cpu_ms", times_json(upload_ms_)},
            {"contours", study_->contours().size()},
            {"contours_cpu_ms", study_->cost().contours_cpu_ms},
            {"last",
             {{"status", outcome_name(section.status)},
              {"paths", section.path_count()},
              {"area", section.area},
              {"length", section.length},
              {"triangles", section.triangles().size() / 3}}}};
}

int run_inside(const Options& options)
{
    const RunSetup setup = read_run_setup(options);
    for (const std::string& message : setup.messages) std::cerr << "kerf-viewer: " << message << "\n";
    std::optional<Window> window;
    std::optional<render::OffscreenContext> context;
    std::unique_ptr<Display> display;
    if (options.headless) {
        context.emplace();
        display = std::make_unique<OffscreenDisplay>(glm::ivec2(options.width, options.height));
    } else {
        window.emplace(options.width, options.height, options.fullscreen, "Kerf");
        display = std::make_unique<WindowDisplay>(*window);
    }
    render::GlErrorLog errors;
    InsideProgram program(options, setup, window ? &*window : nullptr);
    const Pace pace = options.frames > 0 ? Pace::fixed_step : Pace::real_time;
    MainLoop(program, *display, errors,
             {pace, options.frames, options.headless ? options.draw_every : 1, options.screenshot, options.record})
        .run();
    const int status = finish_run(errors);
    if (options.frames > 0) {
        const render::FrameTarget& picture = program.picture();
        Json report = report_head({picture.width(), picture.height()}, errors);
        report["messages"] = program.messages();
        report["runs"] = Json::array({program.report()});
        std::cout << report.dump(2) << "\n";
    }
    return status;
}

}  // namespace kerf::app
