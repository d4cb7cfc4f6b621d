#pragma once

#include <filesystem>

namespace kerf::app {

/// Where the models and fruit of this program lie: as far from the program in the folder of a build as where it is
/// installed, so that nothing depends on where that is. It may not exist: whoever reads from it says so.
std::filesystem::path data_folder();

}  // namespace kerf::app
