#include "viewer/app/game/round.h"

namespace kerf::app {

void Round::advance(const RoundFrame& frame)
{
    const bool is_held = frame.attention == Attention::held;
    clock_.set_time_scale(time_scale());
    if (is_held && !clock_.paused()) let_go();
    clock_.set_paused(is_held);
    const double seconds = fixed_step_ ? double(sim::kTicksPerFrame) * sim::kTickSeconds : frame.seconds;
    if (frame.attention == Attention::played)
        blade_input_.steer(seconds, frame.size);
    else
        blade_input_.release_keys();
    const sim::Tick ticks = !fixed_step_ ? clock_.advance(seconds) : is_held ? 0 : sim::kTicksPerFrame;
    if (ticks > 0) go_on(ticks, blade_input_.take(sim::time_of(now()), sim::time_of(now() + ticks)), frame);
}

void Round::write(ui::Canvas& canvas, const RoundText& text)
{
    write_stage(canvas, text);
    if (text.screen == ui::Screen::play) blade_input_.write(canvas);
}

}  // namespace kerf::app
