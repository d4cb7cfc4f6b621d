#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command_line/whole_number.h"
#include "tools/commands.h"
#include "tools/in_order.h"
#include "tools/input.h"
#include "tools/mesh_files.h"
#include "tools/progress_line.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct ConvertOptions
{
    std::vector<std::string> files;
    std::string input_format;  ///< of the standard input
    std::string out, format, folder;
    unsigned threads = 1;
};

/// FOLDER/NAME.FORMAT, beside the file if no folder is named.
std::filesystem::path converted_name(const std::filesystem::path& file, const ConvertOptions& options)
{
    if (!options.out.empty()) return options.out;
    const std::filesystem::path name = file.stem().string() + "." + options.format;
    return options.folder.empty() ? file.parent_path() / name : std::filesystem::path(options.folder) / name;
}

void check_options(const ConvertOptions& options)
{
    const bool has_input = std::count(options.files.begin(), options.files.end(), "-") > 0;
    if (options.out.empty() == options.format.empty() && options.out != "-")
        throw CLI::ValidationError("say either --out, for one file, or --to, for any number of them");
    if (!options.out.empty() && options.files.size() > 1)
        throw CLI::ValidationError("--out is for one file; use --to for several");
    if (!options.folder.empty() && (options.format.empty() || !options.out.empty()))
        throw CLI::ValidationError("--folder goes with --to");
    if (has_input && options.out.empty()) throw CLI::ValidationError("the standard input has no name: say --out");
    check_standard_output(options.out, options.format);
    for (const std::string& file : options.files) check_input({file, options.input_format});
}

void run(const ConvertOptions& options)
{
    if (options.out == "-") {
        print_mesh(load_input({options.files.front(), options.input_format}).mesh, options.format);
        return;
    }
    MeshFileSet written;
    std::string done;
    ProgressLine progress("files");
    in_order(
        options.files.size(), thread_count(options.threads),
        [&](std::size_t i) {
            return load_input({options.files[i], options.input_format});
        },
        [&](std::size_t i, const LoadedFile& loaded) {
            const std::filesystem::path out = converted_name(options.files[i], options);
            check(written.protect(loaded.report));
            check(written.add(out.c_str(), loaded.mesh));
            const Sentence repairs = describe(loaded.repairs());
            done.append(out.string()).append(": ").append(counted(loaded.mesh.triangle_count(), "triangle"));
            if (!repairs.is_empty()) done.append("; repaired: ").append(repairs.c_str());
            done += "\n";
            progress.show(double(i + 1) / double(options.files.size()));
        });
    check(written.commit());
    print(done);
}

}  // namespace

void add_convert_command(CLI::App& program)
{
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand("convert", "Write mesh files in another format");
    command->add_option("FILE", options->files, "Meshes: obj, ply, stl, off, gltf or glb; - reads the standard input")
        ->required();
    command->add_option("--from", options->input_format, "Format of the standard input");
    command
        ->add_option("-o,--out", options->out,
                     "File to write, for one mesh: obj, ply, stl, off or glb; - is the standard output")
        ->type_name("FILE");
    command
        ->add_option("-t,--to,--format", options->format,
                     "Format of the files to write, for any number of meshes, or of the standard output")
        ->check(CLI::IsMember(writable_formats()));
    command
        ->add_option("-j,--jobs", options->threads, "How many files are read at once; 0: as many as the processor has")
        ->transform(command_line::whole_number(0, kMostThreads))
        ->capture_default_str();
    command->add_option("--folder", options->folder, "Where they are written; otherwise beside what is read")
        ->type_name("FOLDER");
    command->footer(
        "Meshes are repaired as by `kerf repair`; the line that is printed says so. STL and OFF hold positions alone; "
        "PLY\nkeeps every attribute, OBJ and GLB keep materials. If one mesh cannot be read or written, nothing is "
        "written.\n\n"
        "Examples:\n"
        "  kerf convert rook.obj -o rook.glb\n"
        "  kerf convert parts/*.stl --to ply --folder out -j 0\n"
        "  kerf convert - --from stl -o - --format ply < part.stl > part.ply");
    command->callback([options] {
        check_options(*options);
        run(*options);
    });
}

}  // namespace kerf::tools
