#pragma once

#include "viewer/effects/effects.h"
#include "viewer/game/game_state.h"
#include "viewer/sim/camera.h"
#include "viewer/ui/canvas.h"

namespace kerf::ui {

/// Score, lives, clock, special fruit and what they bring, for a game that is on; a hint for who does not know yet.
/// @param shows_hint  that one drags across fruit to cut it
void show_hud(Canvas& canvas, const game::GameState& state, bool shows_hint);

/// Pop-ups and flash of a stage that is seen in `box` of the picture.
void show_effects(Canvas& canvas, const effects::Effects& effects, const Box2& box);

/// Where a place of the stage is on the picture.
glm::vec2 on_picture(const glm::dvec2& stage, const Box2& box);

}  // namespace kerf::ui
