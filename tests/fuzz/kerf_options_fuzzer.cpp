// The command line of kerf: understood, or refused with a reason. Nothing is run.

#include <string>

#include "fuzz/command_line.h"
#include "fuzz/fuzzers.h"
#include "fuzz/require.h"
#include "tools/commands.h"

namespace kerf::core::fuzz {

void fuzz_kerf_options(Bytes bytes)
{
    CommandLine line("kerf", bytes);
    const Silence silence;
    CLI::App program("Kerf cuts triangle meshes by a plane.", "kerf");
    program.require_subcommand(1);
    tools::add_info_command(program);
    tools::add_cut_command(program);
    tools::add_compare_command(program);
    tools::add_shape_command(program);
    // Understood: leave before the command runs.
    program.parse_complete_callback([] { throw CLI::Success(); });
    try {
        program.parse(line.argc(), line.argv());
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success))
            require(!std::string(error.what()).empty(), "wrong use has a reason");
    }
}

}  // namespace kerf::core::fuzz
