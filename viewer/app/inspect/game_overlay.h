#pragma once

#include "viewer/app/user_interface.h"
#include "viewer/effects/effects.h"
#include "viewer/game/game_scene.h"

namespace kerf::app {

/// Everything that is written over the picture of a game that nobody steers: display, pop-ups, and the results when it
/// is over. Between UserInterface::begin() and draw(), with its game letters.
void show_game(const UserInterface& interface, int width, int height, const game::GameScene& game,
               const effects::Effects& effects);

}  // namespace kerf::app
