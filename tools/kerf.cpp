#include <kerf/io.h>
#include <kerf/version.h>

#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "tools/commands.h"

namespace {

constexpr int kUnusable = 1;  ///< a file or a mesh cannot be used, or a comparison failed
constexpr int kWrongUse = 2;
constexpr int kNothingToCut = 3;

/// One line: "kerf cut FILE --normal X,Y,Z --out PREFIX [OPTIONS]".
std::string usage_of(const CLI::App& app, const CLI::App& program)
{
    if (&app == &program) return program.get_name() + " COMMAND [OPTIONS]";
    std::string positionals, required;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional())
            positionals += " " + option->get_name(true);
        else if (option->get_required())
            required += " " + option->get_name() + " " + option->get_type_name();
    }
    return program.get_name() + " " + app.get_name() + positionals + required + " [OPTIONS]";
}

/// Of a command line without a command.
std::string what_is_no_command(const CLI::App& program)
{
    std::string commands;
    for (const CLI::App* command : program.get_subcommands(nullptr))
        commands += (commands.empty() ? "" : ", ") + command->get_name();
    const std::vector<std::string> words = program.remaining();
    return (words.empty() ? "a command is missing" : "there is no command '" + words.front() + "'") +
           ": it is one of " + commands;
}

/// What was wrong with the command line, and how it should look.
int report_wrong_use(const CLI::App& program, const CLI::ParseError& error)
{
    const auto chosen = program.get_subcommands();
    if (chosen.empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
        std::cerr << "kerf: " << what_is_no_command(program) << "\n";
    else
        std::cerr << "kerf: " << error.what() << "\n";
    const CLI::App& app = chosen.empty() ? program : *chosen.front();
    std::cerr << "Usage: " << usage_of(app, program) << "\nRun " << (chosen.empty() ? "kerf" : "kerf " + app.get_name())
              << " --help for more.\n";
    return kWrongUse;
}

int run(int argc, char** argv)
{
    CLI::App program("Kerf cuts triangle meshes by a plane.", "kerf");
    program.set_version_flag("--version", "kerf " KERF_VERSION);
    program.require_subcommand(1);
    program.footer(
        "Exit status: 0 done (a plane that misses is no error), 1 a file or mesh cannot be used or a comparison "
        "failed,\n"
        "2 wrong use, 3 a plane that misses with --require-cut.\n"
        "Run kerf COMMAND --help for the options of a command.");
    kerf::tools::add_info_command(program);
    kerf::tools::add_cut_command(program);
    kerf::tools::add_dice_command(program);
    kerf::tools::add_fracture_command(program);
    kerf::tools::add_section_command(program);
    kerf::tools::add_compare_command(program);
    kerf::tools::add_repair_command(program);
    kerf::tools::add_convert_command(program);
    kerf::tools::add_shape_command(program);
    kerf::tools::add_completion_command(program);

    try {
        program.parse(argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        const bool is_help = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
        return is_help ? program.exit(error) : report_wrong_use(program, error);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    kerf::remove_unfinished_files_on_signals();
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::cerr << "kerf: there is not enough memory; give it a smaller mesh, or free some\n";
    } catch (const kerf::tools::NothingToCut& miss) {
        std::cerr << "kerf: " << miss.what() << "\n";
        return kNothingToCut;
    } catch (const std::exception& error) {
        std::cerr << "kerf: " << error.what() << "\n";
    }
    return kUnusable;
}
