#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>

// The subcommands of `kerf`, one file each. Each adds itself to the program with its options, help and examples, and
// runs while the command line is parsed. Wrong use is a CLI::ParseError; anything else that goes wrong is a
// std::exception whose what() is one sentence.

namespace kerf::tools {

/// A plane that misses, where the user has said that this is an error: the program's exit status is another one then.
class NothingToCut : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

void add_completion_command(CLI::App& program);
void add_info_command(CLI::App& program);
void add_convert_command(CLI::App& program);
void add_cut_command(CLI::App& program);
void add_compare_command(CLI::App& program);
void add_repair_command(CLI::App& program);
void add_dice_command(CLI::App& program);
void add_fracture_command(CLI::App& program);
void add_section_command(CLI::App& program);
void add_shape_command(CLI::App& program);

}  // namespace kerf::tools
