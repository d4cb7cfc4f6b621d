#include "viewer/app/run_setup.h"

#include <kerf/mesh.h>

#include <array>
#include <stdexcept>

#include "common/files/file_places.h"
#include "common/files/output_file.h"
#include "viewer/game/fruit_models.h"
#include "viewer/game/game_mode.h"
#include "viewer/render/picture.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/body_proxies.h"

namespace kerf::app {

namespace {

const std::string& first_said(const std::string& by_command_line, const std::string& by_script,
                              const std::string& otherwise)
{
    if (!by_command_line.empty()) return by_command_line;
    return by_script.empty() ? otherwise : by_script;
}

/// What the scene report throws, and the scene section looks into.
void add_thrown_models(RunSetup& setup, const Options& options)
{
    if (options.files.empty()) setup.models->add_report_models(options.data_folder / "models");
    for (const std::filesystem::path& file : options.files) {
        try {
            const std::size_t model = setup.models->add_file(file);
            if (setup.models->model(model).coarse_coordinates)
                setup.messages.push_back(file.string() + ": " + kCoarseCoordinatesText);
        } catch (const core::io::FileError& error) {
            setup.messages.emplace_back(error.what());
        }
    }
    if (setup.models->empty()) throw core::io::FileError(setup.messages.front());
}

/// Runs in fixed steps must not depend on how fast a thread is, and recordings say themselves when something was ready.
sim::Readiness readiness_for(const Options& options, const sim::Script& script)
{
    for (const sim::InputEvent& event : script.events)
        if (event.kind == sim::InputKind::command && (event.text == "show" || event.text.starts_with("break ")))
            return sim::Readiness::on_command;
    return (options.headless && options.waits) || (!options.headless && options.frames > 0)
               ? sim::Readiness::at_once
               : sim::Readiness::when_ready;
}

}  // namespace

sim::Settings settings_of(const Options& options, const sim::Script& script, const std::string& otherwise)
{
    sim::Settings settings;
    settings.scene = first_said(options.scene, script.scene, otherwise);
    const std::string backend =
        first_said(options.backends.empty() ? std::string() : options.backends.front(), script.backend, {});
    settings.backend = sim::known_back_end(backend);
    if (!backend.empty() && settings.backend.empty())
        throw std::invalid_argument("there is no back end '" + backend + "'");
    if (const std::string proxy = first_said(options.proxy, script.proxy, {}); !proxy.empty()) {
        const std::optional<sim::ProxyKind> kind = sim::find_proxy(proxy);
        if (!kind) throw std::invalid_argument("there is no collision proxy '" + proxy + "'");
        settings.proxy = *kind;
    }
    settings.seed = options.seed.value_or(script.seed.value_or(settings.seed));
    settings.record = !options.save_script.empty();
    return settings;
}

RunSetup read_run_setup(const Options& options)
{
    RunSetup setup;
    if (!options.script.empty()) setup.script = sim::read_script(options.script);
    setup.settings = settings_of(options, setup.script, "report");
    const sim::Settings& settings = setup.settings;
    if (options.giant > 0 && settings.scene == "giant") {
        const std::string size = "size " + std::to_string(options.giant);
        setup.script.events.insert(setup.script.events.begin(), {1, sim::InputKind::command, {}, size});
    }
    setup.readiness = setup.settings.breaks = readiness_for(options, setup.script);

    setup.models = std::make_shared<sim::ModelLibrary>();
    if (settings.scene == "report" || settings.scene == "shatter" || settings.scene == "section") {
        add_thrown_models(setup, options);
    } else if (game::find_mode(settings.scene)) {
        game::add_fruit_models(*setup.models, options.data_folder / "fruit");
    }
    refuse_to_replace(options, *setup.models);
    return setup;
}

void refuse_to_replace(const Options& options, const sim::ModelLibrary& models)
{
    std::vector<std::filesystem::path> inputs(options.files.begin(), options.files.end()), outputs;
    if (!options.script.empty()) inputs.emplace_back(options.script);
    for (std::size_t i = 0; i < models.size(); ++i)
        inputs.insert(inputs.end(), models.model(i).files.begin(), models.model(i).files.end());
    for (const std::filesystem::path& output : {options.screenshot, options.save_script}) {
        if (output.empty()) continue;
        core::io::refuse_to_replace(output, inputs);
        core::io::refuse_same_place(output, outputs);
        outputs.push_back(output);
    }
    if (options.record.empty()) return;
    for (const std::filesystem::path& frame : render::Recording::frames_in(options.record))
        core::io::refuse_to_replace(frame, inputs);
    for (const std::filesystem::path& output : outputs)
        for (const std::filesystem::path& name : {output, core::io::place_of(output)})
            if (render::Recording::is_frame(name))
                core::io::refuse_same_place(output, std::array{options.record / name.filename()});
}

}  // namespace kerf::app
