#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/options.h"
#include "viewer/game/scenes.h"
#include "viewer/sim/model_library.h"
#include "viewer/sim/script.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

/// What runs are made of: models, input and the settings they start with. With a window and without one alike.
struct RunSetup
{
    std::shared_ptr<sim::ModelLibrary> models;
    sim::Script script;  ///< empty without --script
    sim::Settings settings;
    sim::Readiness readiness = sim::Readiness::at_once;
    std::vector<std::string> messages;  ///< models that could not be read, one sentence each

    /// What settings.scene names, to hand to a Simulation.
    /// @param best  score to beat, for games that count
    /// @throws std::invalid_argument  there is no such scene
    std::unique_ptr<sim::Scene> make_scene(std::int64_t best = 0) const
    {
        return game::make_scene(settings.scene, models, {best, readiness});
    }
};

/// What a run starts with: what the command line says goes before what the script says.
/// @param otherwise  the scene that is played when neither names one
/// @throws std::invalid_argument  the script names a back end or a collision proxy that there is not
sim::Settings settings_of(const Options& options, const sim::Script& script, const std::string& otherwise);

/// Reads the script and the models that its scene throws, for settings_of() them.
/// A model that cannot be read is a message as long as there is another one.
/// @throws core::io::FileError          no model can be read, or the script cannot; or the run would write over one of
///                                     them
/// @throws std::invalid_argument  the script names a collision proxy that there is not
RunSetup read_run_setup(const Options& options);

/// @param models  what was read
/// @throws core::io::FileError  a picture or the script that the run is to write would replace what it reads, or
///                             another one
void refuse_to_replace(const Options& options, const sim::ModelLibrary& models);

}  // namespace kerf::app
