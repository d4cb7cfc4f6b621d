#include "viewer/app/main_loop.h"

#include <utility>

namespace kerf::app {

MainLoop::MainLoop(Program& program, Display& display, render::GlErrorLog& errors, LoopPlan plan)
    : program_(program), display_(display), errors_(errors), plan_(std::move(plan))
{
    if (!plan_.record.empty()) recording_.emplace(plan_.record);
}

void MainLoop::run()
{
    while (frame()) {
    }
}

bool MainLoop::frame()
{
    if (!display_.poll() || program_.has_ended()) return false;
    const bool is_last = plan_.frames > 0 && number_ + 1 >= plan_.frames;
    const Frame frame{number_++, plan_.pace, 1e-3 * since_last_.lap(), is_last};
    in_frame_.lap();
    program_.advance(frame);
    const glm::ivec2 size = display_.size();
    if (size.x > 0 && size.y > 0 && is_drawn(frame))
        draw(frame, size);
    else
        program_.sync();
    errors_.check();
    if (is_last && !plan_.screenshot.empty()) render::write_png(plan_.screenshot, program_.picture().read());
    return !is_last;
}

bool MainLoop::is_drawn(const Frame& frame) const
{
    if (recording_ || (frame.is_last && !plan_.screenshot.empty())) return true;
    return plan_.draw_every > 0 && frame.number % plan_.draw_every == 0;
}

void MainLoop::draw(const Frame& frame, const glm::ivec2& size)
{
    program_.draw(frame, size);
    if (recording_) recording_->add(program_.picture().read());
    display_.show(program_.picture());
    program_.take_frame_time(in_frame_.lap());
}

}  // namespace kerf::app
