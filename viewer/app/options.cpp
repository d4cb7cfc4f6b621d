#include "viewer/app/options.h"

#include <kerf/version.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <sstream>
#include <string_view>

#include "command_line/whole_number.h"
#include "viewer/app/data_folder.h"
#include "viewer/app/exit_status.h"
#include "viewer/game/scenes.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/body_proxies.h"
#include "viewer/ui/screens.h"

namespace kerf::app {

namespace {

constexpr std::uint64_t kMostFrames = 1'000'000'000;  // half a year

/// "1280x720".
bool parse_size(const std::string& text, int& width, int& height)
{
    constexpr int kMost = 16384;
    const auto parse = [](std::string_view word, int& number) {
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        return error == std::errc() && end == word.data() + word.size() && number >= 1 && number <= kMost;
    };
    const std::string_view words = text;
    const std::size_t cross = words.find('x');
    return cross != std::string_view::npos && parse(words.substr(0, cross), width) &&
           parse(words.substr(cross + 1), height);
}

/// "1.5,-0.5", within a hundred metres of the middle.
bool parse_place(const std::string& text, glm::vec2& place)
{
    char rest = 0;
    constexpr float kMost = 100.0f;
    return std::sscanf(text.c_str(), "%f,%f%c", &place.x, &place.y, &rest) == 2 && std::abs(place.x) <= kMost &&
           std::abs(place.y) <= kMost;
}

/// CLI::Range lets through what is no number.
CLI::Validator number_between(double least, double most)
{
    const auto check = [least, most](std::string& text) -> std::string {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) return {};
        std::ostringstream reason;
        reason << "'" << text << "' is no number from " << least << " to " << most;
        return reason.str();
    };
    std::ostringstream range;
    range << least << " to " << most;
    return CLI::Validator(check, range.str());
}

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::vector<std::string> proxy_names()
{
    std::vector<std::string> names;
    for (const sim::ProxyKind kind : sim::kProxyKinds) names.emplace_back(sim::proxy_name(kind));
    return names;
}

/// Those that a simulation plays alone, and those that only the game has.
std::vector<std::string> all_scenes()
{
    std::vector<std::string> names = game::scene_names();
    for (const char* name : {"duel", "menu", "section"}) names.emplace_back(name);
    return names;
}

/// Whether a run is played by the program, for so long or to the end of its input.
bool runs_by_itself(const Options& options)
{
    return options.frames > 0 || options.autopilot || !options.script.empty() || !options.record.empty();
}

}  // namespace

bool wants_game(const Options& options)
{
    // Menu, screens and duel are more than one simulation.
    if (options.headless) return options.scene == "menu" || options.scene == "duel" || !options.screen.empty();
    if (options.scene == "section") return false;
    // The game is played in real time and by hand; whoever brings models or input wants to see a simulation.
    const bool brings_something = !options.files.empty() || runs_by_itself(options) || !options.save_script.empty();
    return !brings_something && options.scene != "report" && options.scene != "shatter";
}

ParsedOptions parse_options(int argc, char** argv)
{
    Options options;
    options.data_folder = data_folder();
    std::string size, lighting, backends, zoom_at;
    bool no_panel = false, panel = false, no_vsync = false, no_wait = false;

    CLI::App program("Throws models and lets you cut them with the mouse, with either back end.", "kerf-viewer");
    program.set_version_flag("--version", "kerf-viewer " KERF_VERSION);
    program.add_option("FILE", options.files, "models to throw (default: the game's menu)");
    program.add_option("--data", options.data_folder, "folder that holds models/ and fruit/")->type_name("DIR");
    program.add_option("--scene", options.scene, "what happens")->check(CLI::IsMember(all_scenes()));
    program.add_option("--screen", options.screen, "of the game, for the last picture of --headless")
        ->check(CLI::IsMember(ui::screen_names()));
    program.add_option("--boulder", options.boulder, "triangles of what the scene duel throws")
        ->transform(command_line::whole_number(1000, 2'000'000))
        ->type_name("N");
    program.add_option("--giant", options.giant, "triangles of the scene giant")
        ->transform(command_line::whole_number(game::kFewestGiantTriangles, game::kMostGiantTriangles))
        ->type_name("N");
    program
        .add_option("--backend", backends,
                    "what cuts: " + joined(sim::backend_names()) +
                        "; several with --headless, one run each; in a duel both, or one that meets the default")
        ->type_name("NAME[,NAME]");
    program.add_option("--proxy", options.proxy, "what stands for pieces in the physics engine")
        ->check(CLI::IsMember(proxy_names()));
    program.add_option("--seed", options.seed, "of everything that looks random")
        ->transform(command_line::whole_number())
        ->type_name("N");
    program.add_option("--script", options.script, "play recorded input")->type_name("FILE");
    program.add_option("--save-script", options.save_script, "save the input of this run")->type_name("FILE");
    program.add_flag("--autopilot", options.autopilot, "let the program swipe");
    program.add_flag("--headless", options.headless, "no window: fixed steps, results as JSON");
    program.add_option("--frames", options.frames, "frames of 1/60 s to run (0: to the script's end)")
        ->transform(command_line::whole_number(0, kMostFrames))
        ->type_name("N");
    program.add_flag("--no-wait", no_wait,
                     "with --headless: what threads make appears when it is ready, as in a window; runs differ then");
    program.add_option("--draw", options.draw_every, "with --headless: draw every N-th frame; 0: only a screenshot")
        ->transform(command_line::whole_number(0, kMostFrames))
        ->type_name("N");
    program.add_option("--size", size, "of the picture or window in pixels")->type_name("WxH");
    program.add_option("--screenshot", options.screenshot, "write the last frame as PNG")->type_name("FILE");
    program.add_option("--record", options.record, "write all frames as PNG into a folder")->type_name("DIR");
    program.add_option("--lighting", lighting, "how surfaces are shaded")
        ->check(CLI::IsMember({"lambert", "textured"}));
    program.add_option("--zoom", options.view.zoom, "enlarge the picture")->check(number_between(1.0, 100.0));
    program.add_option("--zoom-at", zoom_at, "place of the stage to enlarge, metres from its middle")->type_name("X,Y");
    program.add_flag("--wireframe", options.view.wireframe, "show the triangles");
    program.add_flag("--proxies", options.view.proxies, "show the collision proxies");
    program.add_flag("--panel", panel, "show the panel over games and in pictures of --headless");
    program.add_flag("--no-panel", no_panel, "start without the panel");
    program.add_flag("--keys", options.view.help, "show the list of keys");
    program.add_option("--ui-scale", options.view.ui_scale, "size of texts (default: the screen's)")
        ->check(number_between(0.5, 8.0));
    program.add_flag("--fullscreen", options.fullscreen, "start on the whole screen");
    program.add_flag("--no-vsync", no_vsync, "do not wait for the screen");
    // Scripts put their own options before the user's: the last one counts.
    for (CLI::Option* option : program.get_options())
        if (option->get_items_expected_max() == 1) option->take_last();
    program.footer(
        "Exit status: 0 done, 1 none of the files can be used (some that cannot are messages), or another file or\n"
        "folder that is named cannot, or a GL error happened, 2 wrong use, 3 no display.");

    try {
        program.parse(argc, argv);
        if (!size.empty() && !parse_size(size, options.width, options.height))
            throw CLI::ValidationError("--size", "'" + size + "' is no size like 1280x720");
        if (!zoom_at.empty() && !parse_place(zoom_at, options.view.zoom_at))
            throw CLI::ValidationError("--zoom-at", "'" + zoom_at + "' is no place like 1.5,-0.5");
        for (const std::string& name : CLI::detail::split(backends, ',')) {
            if (backends.empty()) break;
            const std::string found = sim::known_back_end(name);
            if (found.empty())
                throw CLI::ValidationError(
                    "--backend", "there is no back end '" + name + "': it is one of " + joined(sim::backend_names()));
            options.backends.push_back(found);
        }
        const bool is_duel = options.scene == "duel";
        if (is_duel && options.backends.size() > 2) throw CLI::ValidationError("--backend", "a duel has two back ends");
        const bool has_runs = options.backends.size() > 1 && !is_duel;
        if (has_runs && !options.headless) throw CLI::ValidationError("--backend", "several need --headless");
        const bool has_output = !options.screenshot.empty() || !options.record.empty() || !options.save_script.empty();
        if (has_runs && (options.scene == "menu" || !options.screen.empty()))
            throw CLI::ValidationError("--backend", "the menu and the game's screens are shown with one");
        if (has_runs && has_output)
            throw CLI::ValidationError("--backend", "several cannot share one file for pictures or script");
        const bool is_menu_or_duel = is_duel || options.scene == "menu";
        const bool is_menu = options.scene.empty() && options.script.empty() && !options.screen.empty();
        if ((is_menu_or_duel || is_menu) && !options.save_script.empty())
            throw CLI::ValidationError("--save-script", "menu and duel are not recorded");
        if (is_menu_or_duel && !options.headless && runs_by_itself(options))
            throw CLI::ValidationError(
                "--scene", "menu and duel take --frames, --autopilot, --script and --record only with --headless");
        const bool is_section = options.scene == "section";
        if (!options.files.empty() && !options.scene.empty() && options.scene != "report" &&
            options.scene != "shatter" && !is_section)
            throw CLI::ValidationError("FILE", "only the scenes report, shatter and section show models of your own");
        if (is_section && (has_runs || !options.script.empty() || !options.save_script.empty()))
            throw CLI::ValidationError("--scene", "section has one back end, and neither --script nor --save-script");
        if (no_wait && !options.headless)
            throw CLI::ValidationError("--no-wait", "needs --headless: a window never waits");
        if (options.headless && options.frames == 0 && options.script.empty())
            throw CLI::ValidationError("--headless", "needs --frames or --script");
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
            return {std::nullopt, program.exit(error)};
        std::cerr << "kerf-viewer: " << error.what() << "\nRun kerf-viewer --help for more.\n";
        return {std::nullopt, kWrongUse};
    }
    if (lighting == "lambert") options.view.lighting = render::Lighting::lambert;
    options.waits = !no_wait;
    options.vsync = !no_vsync;
    options.has_size = !size.empty();
    options.wants_panel = panel;
    options.view.panel = options.headless ? panel : !no_panel;
    return {options, kDone};
}

}  // namespace kerf::app
