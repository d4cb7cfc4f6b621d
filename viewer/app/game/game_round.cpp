#include "viewer/app/game/game_round.h"

#include <utility>

#include "viewer/ui/hud.h"

namespace kerf::app {

namespace {

/// From the end of a game to its results.
constexpr sim::Tick kEndShown = 170;

}  // namespace

GameRound::GameRound(RoundSetup setup, bool is_new_player, sound::Speaker& speaker)
    : SimulatedRound(std::move(setup), speaker), is_new_player_(is_new_player)
{
}

bool GameRound::is_over()
{
    return over_at_ && now() - *over_at_ >= kEndShown;
}

std::optional<PlayedGame> GameRound::take_score(bool is_left)
{
    if (is_scored_ || (!over_at_ && !is_left)) return std::nullopt;
    is_scored_ = true;
    return PlayedGame{state().mode, game::score_of(state(), simulation()->backend(), simulation()->settings().seed)};
}

void GameRound::describe(ui::ScreenContent& content, ui::Screen)
{
    content.game = &state();
}

const sim::Blade* GameRound::demo_blade() const
{
    return teaches() && !demo_.is_away(*simulation()) ? &demo_.blade() : nullptr;
}

void GameRound::watch(const RoundFrame&)
{
    if (teaches()) demo_.show_in_game(*simulation(), game());
    if (state().phase != game::GamePhase::over || over_at_) return;
    over_at_ = now();
    speaker().set_fuse(false);
}

void GameRound::write_display(ui::Canvas& canvas, const RoundText& text)
{
    if (text.screen == ui::Screen::over) return;
    const bool hints = teaches() && text.screen == ui::Screen::play && !text.has_message;
    ui::show_hud(canvas, state(), hints ? ui::kHowToPlay : std::string_view());
}

}  // namespace kerf::app
