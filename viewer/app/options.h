#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/view_settings.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

/// The command line of kerf-viewer: it has a member for each option.
struct Options
{
    std::vector<std::filesystem::path> files;  ///< models to throw; empty: the report's fifteen
    std::filesystem::path data_folder;         ///< where `models/` and `fruit/` lie
    std::string screen;                        ///< of the game, for the last frame of --headless; empty: none
    std::int64_t boulder = 0;                  ///< triangles, of the scene duel; 0: its default
    std::string scene;                         ///< empty: the script's, or "report"
    std::int64_t giant = 0;                    ///< triangles at the start of scene giant; 0: its default
    std::vector<std::string> backends;         ///< several: one run each, without a screen only
    std::string proxy;                         ///< empty: the script's, or the default
    std::optional<std::uint64_t> seed;         ///< none: the script's, or 1
    std::filesystem::path script;              ///< input to play
    std::filesystem::path save_script;         ///< where to put what was played
    bool autopilot = false;

    bool headless = false;
    std::int64_t frames = 0;  ///< 0: without a screen as long as the script, with one until the window is closed
    bool waits = true;   ///< without a screen: for what threads make, so that runs are equal; false: as in a window
    int draw_every = 1;  ///< without a screen: pictures; 0: only the last, when somebody wants to see it
    int width = 1280, height = 720;
    bool has_size = false;             ///< it was asked for
    std::filesystem::path screenshot;  ///< of the last frame
    std::filesystem::path record;      ///< folder for all frames

    ViewSettings view;
    bool wants_panel = false;  ///< the panel was asked for
    bool vsync = true;
    bool fullscreen = false;
};

/// Whether these ask for the game with its menu, or for one simulation to look at.
bool wants_game(const Options& options);

/// What parsing a command line led to: options, or an exit status when everything is said already.
struct ParsedOptions
{
    std::optional<Options> options;
    int exit_status = 0;
};

/// Prints help, version or what is wrong.
ParsedOptions parse_options(int argc, char** argv);

}  // namespace kerf::app
