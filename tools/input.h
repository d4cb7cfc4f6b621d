#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tools/mesh_files.h"

// A mesh from a file or from the standard input.

namespace kerf::tools {

struct InputOptions
{
    std::string file;    ///< "-" is the standard input
    std::string format;  ///< of the standard input
};

void add_input_options(CLI::App& command, InputOptions& options);

/// @throws CLI::ValidationError  the standard input has no format
void check_input(const InputOptions& options);

/// @throws FileError
LoadedFile load_input(const InputOptions& options);

}  // namespace kerf::tools
