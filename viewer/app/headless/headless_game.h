#pragma once

#include "viewer/app/options.h"

namespace kerf::app {

/// Pictures of the game without a window: its menu, its screens, a duel. Fixed steps, nothing is stored. Prints a
/// report as JSON; gives the exit status, kUnusable when the graphics driver complained.
/// @throws core::io::FileError, render::RenderError, std::invalid_argument
int run_headless_game(const Options& options);

}  // namespace kerf::app
