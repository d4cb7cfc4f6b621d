#include "viewer/app/inspect/game_overlay.h"

#include "viewer/ui/hud.h"
#include "viewer/ui/screen_view.h"

namespace kerf::app {

void show_game(const UserInterface& interface, int width, int height, const game::GameScene& game,
               const effects::Effects& effects)
{
    ui::Canvas canvas(interface.letters(), {width, height});
    const game::GameState& state = game.state();
    ui::show_effects(canvas, effects, {{0.0f, 0.0f}, canvas.size()});
    if (state.phase != game::GamePhase::over)
        return ui::show_hud(canvas, state, state.counts.fruit_cut == 0 ? ui::kHowToCut : std::string_view());
    ui::Screens screens({}, {});
    screens.play(std::string(game.name()));
    screens.show(ui::Screen::over);
    ui::ScreenContent content;
    content.game = &state;
    ui::show_screen(canvas, screens, content);
}

}  // namespace kerf::app
