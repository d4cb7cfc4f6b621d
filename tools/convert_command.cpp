#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tools/commands.h"
#include "tools/mesh_files.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct ConvertOptions
{
    std::vector<std::string> files;
    std::string out, format, folder;
};

/// FOLDER/NAME.FORMAT, beside the file if no folder is named.
std::filesystem::path converted_name(const std::filesystem::path& file, const ConvertOptions& options)
{
    if (!options.out.empty()) return options.out;
    const std::filesystem::path name = file.stem().string() + "." + options.format;
    return options.folder.empty() ? file.parent_path() / name : std::filesystem::path(options.folder) / name;
}

void run(const ConvertOptions& options)
{
    if (options.out.empty() == options.format.empty())
        throw CLI::ValidationError("say either --out, for one file, or --to, for any number of them");
    if (!options.out.empty() && options.files.size() > 1)
        throw CLI::ValidationError("--out is for one file; use --to for several");
    if (!options.folder.empty() && options.format.empty()) throw CLI::ValidationError("--folder goes with --to");
    MeshFileSet written;
    std::string done;
    for (const std::string& file : options.files) {
        const std::filesystem::path out = converted_name(file, options);
        const LoadedFile loaded = load(file);
        check(written.protect(loaded.report));
        check(written.add(out.c_str(), loaded.mesh));
        const std::string repairs = describe(loaded.repairs()).c_str();
        done += out.string() + ": " + counted(loaded.mesh.triangle_count(), "triangle") +
                (repairs.empty() ? "" : "; repaired: " + repairs) + "\n";
    }
    check(written.commit());
    print(done);
}

}  // namespace

void add_convert_command(CLI::App& program)
{
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand("convert", "Write mesh files in another format");
    command->add_option("FILE", options->files, "Meshes: obj, ply, stl, off, gltf or glb")->required();
    command->add_option("-o,--out", options->out, "File to write, for one mesh: obj, ply, stl, off or glb")
        ->type_name("FILE");
    command->add_option("-t,--to", options->format, "Format of the files to write, for any number of meshes")
        ->check(CLI::IsMember(writable_formats()));
    command->add_option("--folder", options->folder, "Where they are written; otherwise beside what is read")
        ->type_name("FOLDER");
    command->footer(
        "Meshes are repaired as by `kerf repair`; the line that is printed says so. STL and OFF hold positions alone; "
        "PLY\nkeeps every attribute, OBJ and GLB keep materials. If one mesh cannot be read or written, nothing is "
        "written.\n\n"
        "Examples:\n"
        "  kerf convert rook.obj -o rook.glb\n"
        "  kerf convert parts/*.stl --to ply --folder out");
    command->callback([options] { run(*options); });
}

}  // namespace kerf::tools
