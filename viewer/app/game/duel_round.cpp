#include "viewer/app/game/duel_round.h"

#include <algorithm>

namespace kerf::app {

DuelRound::DuelRound(const DuelSetup& setup)
    : Round(setup.settings.scene, setup.fixed_step, DuelView::layout()),
      view_(setup.models, setup.settings, setup.boulder, setup.backends)
{
    if (setup.fixed_step) view_.wait_until_ready();
}

void DuelRound::push(const std::vector<sim::InputEvent>& events)
{
    script_.insert(script_.end(), events.begin(), events.end());
}

void DuelRound::let_play(game::Autopilot& autopilot)
{
    if (!view_.ready()) return;
    duel::Half& watched = view_.duel().half(autopilot.swipes() % 2);
    if (watched.idle() && watched.done() == now()) push(autopilot.play(watched.simulation()));
}

void DuelRound::go_on(sim::Tick ticks, const std::vector<sim::InputEvent>& events, const RoundFrame&)
{
    const auto is_due = [end = now() + ticks](const sim::InputEvent& event) { return sim::tick_of(event.time) <= end; };
    const auto later = std::find_if_not(script_.begin(), script_.end(), is_due);
    std::vector<sim::InputEvent> all = events;
    all.insert(all.end(), script_.begin(), later);
    script_.erase(script_.begin(), later);
    view_.advance(ticks, all, fixed_step());
}

void DuelRound::paint(Painter& painter, const ViewSettings& view)
{
    ViewSettings nearer = view;
    nearer.zoom *= DuelView::kZoom;
    painter.paint(view_.stages(painter.target().width(), painter.target().height()), nearer);
}

void DuelRound::write_stage(ui::Canvas& canvas, const RoundText& text)
{
    if (text.screen != ui::Screen::over) view_.write(canvas);
}

void DuelRound::describe(ui::ScreenContent& content, ui::Screen screen)
{
    if (screen != ui::Screen::over) return;
    for (const duel::Score& score : view_.scores())
        content.duel.push_back(
            {score.backend, score.cuts, score.cut_ms, score.worst_ms, score.worst_frame_ms, score.lost_frames});
}

}  // namespace kerf::app
