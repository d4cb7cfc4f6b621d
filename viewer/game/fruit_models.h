#pragma once

#include <filesystem>

#include "viewer/sim/model_shelf.h"

namespace kerf::game {

/// Puts the models of the whole fruit_catalogue() on the shelf: the files Fruit::model + ".glb" of a folder.
/// @throws io::FileError
void add_fruit_models(sim::ModelShelf& models, const std::filesystem::path& folder);

}  // namespace kerf::game
