#include <memory>
#include <string>

#include "tools/commands.h"
#include "tools/input.h"
#include "tools/mesh_info.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct RepairOptions
{
    InputOptions input;
    std::string out, format;
    bool json = false;
};

void run(const RepairOptions& options)
{
    const LoadedFile loaded = load_input(options.input);
    if (options.out == "-") {
        print_mesh(loaded.mesh, options.format);
        return;
    }
    MeshFileSet files(loaded.report);
    check(files.add(options.out.c_str(), loaded.mesh));
    check(files.commit());
    const bool is_closed = loaded.facts().is_closed();
    if (options.json) {
        print(Json{{"file", options.input.file},
                   {"out", options.out},
                   {"triangles", loaded.mesh.triangle_count()},
                   {"triangles_before", loaded.facts().triangles},
                   {"closed", is_closed},
                   {"notes", notes_json(loaded.report)},
                   {"repairs", repairs_json(loaded.repairs())}});
        return;
    }
    const Sentence repairs = describe(loaded.repairs());
    print(options.out + ": " + counted(loaded.mesh.triangle_count(), "triangle") + ", " +
          (is_closed ? "closed" : "with a boundary") + "; " +
          (repairs.is_empty() ? "nothing had to be repaired" : repairs.c_str()) + "\n");
}

}  // namespace

void add_repair_command(CLI::App& program)
{
    auto options = std::make_shared<RepairOptions>();
    CLI::App* command = program.add_subcommand("repair", "Write a mesh file as it is cut: repaired");
    add_input_options(*command, options->input);
    command->add_option("-o,--out", options->out, "File to write: obj, ply, stl, off or glb; - is the standard output")
        ->required()
        ->type_name("FILE");
    command->add_option("--format", options->format, "Format of the standard output")
        ->check(CLI::IsMember(writable_formats()).description(""));
    command->add_flag("--json", options->json, "Print JSON instead of text");
    command->footer(
        "No vertex is moved, and no hole is filled: triangles without an area that two of their corners give away are\n"
        "dropped, repeated ones too, edges and points where several surfaces meet are taken apart, and triangles that\n"
        "face the wrong way are turned over. What was done is printed.\n\n"
        "Examples:\n"
        "  kerf repair scan.stl -o scan.ply\n"
        "  kerf repair scan.stl -o scan.ply --json | jq .repairs\n"
        "  kerf repair - -o - --format stl < scan.stl > repaired.stl");
    command->callback([options] {
        take_format(options->input, options->format);
        check_input(options->input);
        check_standard_output(options->out, options->format);
        if (options->out == "-" && options->json)
            throw CLI::ValidationError("--json", "the standard output takes one mesh, and nothing besides");
        run(*options);
    });
}

}  // namespace kerf::tools
