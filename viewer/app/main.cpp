#include <csignal>
#include <exception>
#include <iostream>
#include <new>

#include "common/io/unfinished_files.h"
#include "viewer/app/exit_status.h"
#include "viewer/app/headless.h"
#include "viewer/app/options.h"
#include "viewer/app/player.h"
#include "viewer/render/render_error.h"

namespace {

/// An interrupted program leaves no half a file behind, and ends as if the signal had not been caught.
void remove_unfinished_and_end(int signal_number)
{
    kerf::io::remove_unfinished_files();
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);
}

}  // namespace

int main(int argc, char** argv)
{
    using namespace kerf::app;
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal_number, remove_unfinished_and_end);
    try {
        const ParsedOptions parsed = parse_options(argc, argv);
        if (!parsed.options) return parsed.exit_status;
        return parsed.options->headless ? run_headless(*parsed.options) : run_player(*parsed.options);
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
