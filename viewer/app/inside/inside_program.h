#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/inside/inside_view.h"
#include "viewer/app/main_loop.h"
#include "viewer/app/options.h"
#include "viewer/app/run_setup.h"
#include "viewer/app/user_interface.h"
#include "viewer/app/window.h"
#include "viewer/inside/study.h"
#include "viewer/ui/notice.h"

namespace kerf::app {

/// The scene section: a model, and a plane through it that is moved and turned by the mouse, or by the program along the
/// same path in every run.
class InsideProgram : public Program
{
public:
    /// @param window  null: without one, and the program moves the plane
    /// @throws render::RenderError, core::io::FileError  none of the models can be prepared
    InsideProgram(const Options& options, const RunSetup& setup, Window* window);

    void advance(const Frame& frame) override;
    void sync() override;
    void draw(const Frame& frame, const glm::ivec2& size) override;
    const render::FrameTarget& picture() const override { return view_.target(); }

    const inside::Study& study() const { return *study_; }
    const std::vector<std::string>& messages() const { return messages_; }
    /// What the sections of the run have cost, and what the last one says.
    nlohmann::ordered_json report() const;

private:
    void show_model(std::size_t first);
    void use_back_end(const std::string& name);
    void move_by_itself(const Frame& frame);
    void take_keys();
    void act(int key);
    void take_pointer();
    void update();
    void save_picture();
    void say(std::string message);

    std::shared_ptr<sim::ModelLibrary> models_;
    ViewSettings settings_;
    const bool moves_by_itself_;
    Window* window_;
    InsideView view_;
    std::optional<UserInterface> interface_;
    std::string back_end_;
    std::size_t model_ = 0;
    std::optional<inside::Study> study_;
    std::optional<glm::dvec2> pointer_;  ///< where it was, stage; while a button is down
    bool is_new_ = true;                 ///< the section is not on the graphics card yet
    ui::Notice notice_;
    std::vector<std::string> messages_;
    std::vector<double> section_ms_, upload_ms_;  ///< processor time of each section
    bool has_written_ = false;
};

/// Shows the scene section until its window is closed, or for so many frames; with those a report goes to standard
/// output. Gives the exit status.
/// @throws render::RenderError, core::io::FileError, std::invalid_argument
int run_inside(const Options& options);

}  // namespace kerf::app
