#pragma once

#include <filesystem>

#include "viewer/sim/model_library.h"

namespace kerf::game {

/// Adds the models of the whole fruit_catalogue() to the library: the files Fruit::model + ".glb" of a folder.
/// @throws core::io::FileError
void add_fruit_models(sim::ModelLibrary& models, const std::filesystem::path& folder);

}  // namespace kerf::game
