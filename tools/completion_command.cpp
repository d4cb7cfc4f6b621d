#include <algorithm>
#include <cctype>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tools/commands.h"
#include "tools/mesh_files.h"
#include "tools/registry.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

/// Every name of every option, as it is typed.
std::string options_of(const CLI::App& command)
{
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_snames()) words.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    }
    return joined(words);
}

/// The words that an option takes.
std::map<std::string, std::string> choices()
{
    const std::string written = joined(writable_formats());
    std::string read;
    for (std::size_t i = 0; const char* format = readable_format(i); ++i)
        read += (i == 0 ? "" : " ") + std::string(format);
    return {{"--backend", joined(backend_choices())},
            {"--cap-quality", "fast delaunay"},
            {"--format", written + " svg dxf json"},
            {"--from", read},
            {"--keep", "positive negative"},
            {"--to", written},
            {"--unit", "mm cm m in ft"}};
}

std::string bash_script(const CLI::App& program)
{
    std::string commands, cases;
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
        commands += (commands.empty() ? "" : " ") + command->get_name();
        cases += "        " + command->get_name() + ") words='" + options_of(*command) + "' ;;\n";
    }
    std::string values;
    for (const auto& [option, words] : choices())
        values += "        " + option + ") COMPREPLY=($(compgen -W '" + words + "' -- \"$word\")); return ;;\n";
    std::string meshes;
    for (std::size_t i = 0; const char* format = readable_format(i); ++i) {
        std::string upper = format;
        std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
        meshes += (i == 0 ? "" : " ") + std::string(format) + " " + upper;
    }
    return "# Completion of kerf for bash: written by `kerf completion bash`.\n"
           "_kerf()\n"
           "{\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words=\n"
           "    COMPREPLY=()\n"
           "    if ((COMP_CWORD == 1)); then\n"
           "        COMPREPLY=($(compgen -W '" +
           commands + " --help --version' -- \"$word\"))\n" +
           "        return\n"
           "    fi\n"
           "    case $before in\n" +
           values +
           "        --out | -o | --results | --batch | --planes | --folder)\n"
           "            compopt -o filenames 2> /dev/null; COMPREPLY=($(compgen -f -- \"$word\")); return ;;\n"
           "    esac\n"
           "    case ${COMP_WORDS[1]} in\n" +
           cases +
           "    esac\n"
           "    if [[ $word == -* ]]; then\n"
           "        COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    # Meshes, and folders that lead to some.\n"
           "    local IFS=$'\\n' extension\n"
           "    compopt -o filenames 2> /dev/null\n"
           "    COMPREPLY=($(compgen -d -- \"$word\"\n"
           "        IFS=' '; for extension in " +
           meshes +
           "; do compgen -f -X \"!*.$extension\" -- \"$word\"; done))\n"
           "}\n"
           "complete -F _kerf kerf\n";
}

}  // namespace

void add_completion_command(CLI::App& program)
{
    auto shell = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("completion", "Print what completes command lines in a shell");
    command->add_option("SHELL", *shell, "bash")->required()->check(CLI::IsMember({"bash"}).description(""));
    command->footer(
        "Debian's package installs it. Otherwise:\n\n"
        "  source <(kerf completion bash)");
    command->callback([&program, shell] { print(bash_script(program)); });
}

}  // namespace kerf::tools
