#include <exception>
#include <iostream>
#include <new>

#include "common/files/unfinished_files.h"
#include "viewer/app/exit_status.h"
#include "viewer/app/game/game_window.h"
#include "viewer/app/headless/headless_game.h"
#include "viewer/app/headless/headless_inspection.h"
#include "viewer/app/inside/inside_program.h"
#include "viewer/app/inspect/inspection_window.h"
#include "viewer/app/options.h"
#include "viewer/render/render_error.h"

namespace {

int run(const kerf::app::Options& options)
{
    using namespace kerf::app;
    if (options.scene == "section") return run_inside(options);
    if (wants_game(options)) return options.headless ? run_headless_game(options) : run_game(options);
    return options.headless ? run_headless_inspection(options) : run_inspection(options);
}

}  // namespace

int main(int argc, char** argv)
{
    using namespace kerf::app;
    kerf::core::io::remove_unfinished_files_on_signals();
    try {
        const ParsedOptions parsed = parse_options(argc, argv);
        if (!parsed.options) return parsed.exit_status;
        return run(*parsed.options);
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
