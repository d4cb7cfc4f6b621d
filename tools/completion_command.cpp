#include <kerf/shapes.h>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>
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

std::string all_of(const char* (*name)(std::size_t))
{
    std::vector<std::string> words;
    for (std::size_t i = 0; name(i) != nullptr; ++i) words.emplace_back(name(i));
    return joined(words);
}

/// The words that options take: of any command by the option, of one by "COMMAND OPTION". None: some text, which nobody
/// can guess.
std::map<std::string, std::string> choices()
{
    const std::string written = joined(writable_formats()), read = all_of(&readable_format);
    return {{"--backend", joined(backend_choices())},
            {"--cap-quality", "fast delaunay"},
            {"--format", written},
            {"--from", read},
            {"--keep", "positive negative"},
            {"--to", written},
            {"--unit", "mm cm m in ft"},
            {"info --format", read},
            {"section --format", "svg dxf obj json"}};
}

/// Options that take a file.
constexpr const char* kFileOptions[] = {"--out", "-o", "--results", "--batch", "--planes", "--folder"};

std::string quoted(const std::string& words)
{
    return "'" + words + "'";
}

/// Words for what stands before, by "COMMAND OPTION".
std::string cases_of_options(const CLI::App& program)
{
    std::string cases;
    const auto known = choices();
    for (const CLI::App* command : program.get_subcommands(nullptr))
        for (const CLI::Option* option : command->get_options()) {
            std::vector<std::string> names;
            for (const std::string& name : option->get_snames()) names.push_back("-" + name);
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
            for (const std::string& name : names) {
                if (option->get_items_expected_max() == 0 || std::ranges::count(kFileOptions, name) > 0) continue;
                auto found = known.find(command->get_name() + " " + name);
                if (found == known.end()) found = known.find(name);
                const std::string words = found != known.end() ? found->second : "";
                cases.append("        '").append(command->get_name()).append(" ").append(name).append("') ");
                cases.append("COMPREPLY=($(compgen -W ").append(quoted(words)).append(" -- \"$word\")); return ;;\n");
            }
        }
    return cases;
}

std::string bash_script(const CLI::App& program)
{
    std::string commands, cases, meshes;
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
        commands += command->get_name() + " ";
        cases += "        " + command->get_name() + ") words='" + options_of(*command) + "' ;;\n";
    }
    for (std::size_t i = 0; const char* format = readable_format(i); ++i) {
        std::string upper = format;
        std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
        meshes += (i == 0 ? "" : " ") + std::string(format) + " " + upper;
    }
    std::string script = R"(# Completion of kerf for bash: written by `kerf completion bash`.
_kerf()
{
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} words=
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        COMPREPLY=($(compgen -W '@COMMANDS@--help --version' -- "$word"))
        return
    fi
    # --option=word is three words.
    [[ $word == '=' ]] && word= && before==
    [[ $before == '=' ]] && before=${COMP_WORDS[COMP_CWORD - 2]} && [[ ${COMP_WORDS[COMP_CWORD]} == '=' ]] &&
        before=${COMP_WORDS[COMP_CWORD - 1]}
    case "$command $before" in
@OPTIONS@        *' --out' | *' -o' | *' --results' | *' --batch' | *' --planes' | *' --folder')
            compopt -o filenames 2> /dev/null
            COMPREPLY=($(compgen -f -- "$word"))
            return ;;
        'shape shape') COMPREPLY=($(compgen -W '@SHAPES@' -- "$word")); return ;;
        'completion completion') COMPREPLY=($(compgen -W 'bash' -- "$word")); return ;;
    esac
    case $command in
@COMMAND_CASES@        *) return ;;
    esac
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$words" -- "$word"))
        return
    fi
    # Meshes, and folders that lead to some.
    local IFS=$'\n' extension
    compopt -o filenames 2> /dev/null
    COMPREPLY=($(compgen -d -- "$word"
        IFS=' '; for extension in @MESHES@; do compgen -f -X "!*.$extension" -- "$word"; done))
}
complete -F _kerf kerf
)";
    for (const auto& [mark, text] : {std::pair<std::string, std::string>{"@COMMANDS@", commands},
                                     {"@OPTIONS@", cases_of_options(program)},
                                     {"@SHAPES@", all_of(&shape_name)},
                                     {"@COMMAND_CASES@", cases},
                                     {"@MESHES@", meshes}})
        script.replace(script.find(mark), mark.size(), text);
    return script;
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
