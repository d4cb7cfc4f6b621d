#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/options.h"
#include "viewer/sim/model_shelf.h"
#include "viewer/sim/script.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

/// What runs are made of: models, input and the settings they start with. With a window and without one alike.
struct Session
{
    std::shared_ptr<sim::ModelShelf> models;
    sim::Script script;  ///< empty without --script
    sim::Settings settings;
    std::vector<std::string> messages;  ///< models that could not be read, one sentence each
};

/// Reads models and script. What the command line says goes before what the script says. A model that cannot be read is
/// a message as long as there is another one.
/// @throws io::FileError  no model can be read, or the script cannot
Session open_session(const Options& options);

}  // namespace kerf::app
