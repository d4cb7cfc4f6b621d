#include <memory>
#include <string>

#include "common/io/mesh_file.h"
#include "tools/commands.h"
#include "tools/mesh_info.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct RepairOptions
{
    std::string file, out;
    bool json = false;
};

void run(const RepairOptions& options)
{
    const io::LoadedMesh loaded = io::read_mesh(options.file);
    io::MeshFileSet files(loaded.files);
    files.add(options.out, *loaded.mesh);
    files.commit();
    const bool is_closed = loaded.is_closed();
    if (options.json) {
        print(Json{{"file", options.file},
                   {"out", options.out},
                   {"triangles", loaded.mesh->triangles.size()},
                   {"triangles_before", loaded.facts.triangles},
                   {"closed", is_closed},
                   {"notes", notes_json(loaded.notes)},
                   {"repairs", repairs_json(loaded.repairs)}});
        return;
    }
    print(options.out + ": " + counted(loaded.mesh->triangles.size(), "triangle") + ", " +
          (is_closed ? "closed" : "with a boundary") + "; " +
          (loaded.repairs.none() ? "nothing had to be repaired" : loaded.repairs.describe()) + "\n");
}

}  // namespace

void add_repair_command(CLI::App& program)
{
    auto options = std::make_shared<RepairOptions>();
    CLI::App* command = program.add_subcommand("repair", "Write a mesh file as it is cut: repaired");
    command->add_option("FILE", options->file, "Mesh: obj, ply, stl, off, gltf or glb")->required();
    command->add_option("-o,--out", options->out, "File to write: obj, ply, stl, off or glb")
        ->required()
        ->type_name("FILE");
    command->add_flag("--json", options->json, "Print JSON instead of text");
    command->footer(
        "No vertex is moved, and no hole is filled: triangles without an area that two of their corners give away are\n"
        "dropped, repeated ones too, edges and points where several surfaces meet are taken apart, and triangles that\n"
        "face the wrong way are turned over. What was done is printed.\n\n"
        "Examples:\n"
        "  kerf repair scan.stl -o scan.ply\n"
        "  kerf repair scan.stl -o scan.ply --json | jq .repairs");
    command->callback([options] { run(*options); });
}

}  // namespace kerf::tools
