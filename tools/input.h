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

/// The standard input has the format of what is written if nothing else was said.
inline void take_format(InputOptions& options, const std::string& format)
{
    if (options.format.empty()) options.format = format;
}

/// @throws CLI::ValidationError  the standard input has no format
void check_input(const InputOptions& options);

/// @throws CLI::ValidationError  what is written to the standard output has no format
void check_standard_output(const std::string& out, const std::string& format);

/// @throws FileError
LoadedFile load_input(const InputOptions& options);

/// A mesh as a file of that format, to the standard output.
/// @throws FileError
void print_mesh(const Mesh& mesh, const std::string& format);

}  // namespace kerf::tools
