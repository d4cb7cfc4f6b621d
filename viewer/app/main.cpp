#include <exception>
#include <iostream>
#include <new>

#include "common/io/unfinished_files.h"
#include "viewer/app/exit_status.h"
#include "viewer/app/game/game_window.h"
#include "viewer/app/headless/headless.h"
#include "viewer/app/headless/headless_game.h"
#include "viewer/app/inspect/player.h"
#include "viewer/app/options.h"
#include "viewer/render/render_error.h"

namespace {

/// The game is played in real time and by hand; whoever brings models, a script or a number of frames wants to see a
/// simulation.
bool is_game(const kerf::app::Options& options)
{
    return options.files.empty() && options.script.empty() && options.frames == 0 && !options.autopilot &&
           options.record.empty() && options.save_script.empty() && options.scene != "report";
}

/// Menu, screens and duel are more than one simulation.
bool needs_game(const kerf::app::Options& options)
{
    return options.scene == "menu" || options.scene == "duel" || !options.screen.empty();
}

}  // namespace

int main(int argc, char** argv)
{
    using namespace kerf::app;
    kerf::io::remove_unfinished_files_on_signals();
    try {
        const ParsedOptions parsed = parse_options(argc, argv);
        if (!parsed.options) return parsed.exit_status;
        const Options& options = *parsed.options;
        if (options.headless) return needs_game(options) ? run_headless_game(options) : run_headless(options);
        return is_game(options) ? run_game(options) : run_player(options);
    } catch (const kerf::render::NoDisplay& error) {
        std::cerr << "kerf-viewer: " << error.what() << "\n";
        return kNoDisplay;
    } catch (const std::bad_alloc&) {
        std::cerr << "kerf-viewer: there is not enough memory\n";
    } catch (const std::exception& error) {
        std::cerr << "kerf-viewer: " << error.what() << "\n";
    }
    return kUnusable;
}
