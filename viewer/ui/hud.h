#pragma once

#include <string_view>

#include "viewer/effects/effects.h"
#include "viewer/game/game_state.h"
#include "viewer/sim/camera.h"
#include "viewer/ui/canvas.h"

namespace kerf::ui {

/// For who does not know yet how fruit are cut, and what a player who holds the keyboard can do besides.
inline constexpr std::string_view kHowToCut = "Hold the left button and drag across the fruit";
inline constexpr std::string_view kHowToPlay =
    "Hold the left button and drag across the fruit\n"
    "or steer with W A S D and hold Space to cut   Esc: pause";

/// Score, lives, clock, special fruit and what they bring, for a game that is on.
/// @param hint  at the lower edge; empty: none
void show_hud(Canvas& canvas, const game::GameState& state, std::string_view hint);

/// Pop-ups and flash of a stage that is seen in `box` of the picture.
void show_effects(Canvas& canvas, const effects::Effects& effects, const Box2& box);

/// Where a place of the stage is on the picture.
glm::vec2 on_picture(const glm::dvec2& stage, const Box2& box);

}  // namespace kerf::ui
