#include "tools/input.h"

#include <iostream>
#include <iterator>
#include <span>
#include <string>
#include <utility>

#include "tools/text.h"

namespace kerf::tools {

void add_input_options(CLI::App& command, InputOptions& options)
{
    command.add_option("FILE", options.file, "Mesh: obj, ply, stl, off, gltf or glb; - reads the standard input")
        ->required();
    command.add_option("--from", options.format, "Format of the standard input");
}

void check_input(const InputOptions& options)
{
    if (options.file == "-" && options.format.empty())
        throw CLI::ValidationError("--from", "the standard input needs a format, such as --from stl");
}

void check_standard_output(const std::string& out, const std::string& format)
{
    if (out == "-" && format.empty())
        throw CLI::ValidationError("--format", "the standard output needs a format, such as --format stl");
}

LoadedFile load_input(const InputOptions& options)
{
    if (options.file != "-") return load(options.file);
    const std::string bytes{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
    LoadedFile file;
    Result<Mesh> mesh = read_mesh(std::as_bytes(std::span(bytes)), options.format.c_str(), &file.report);
    if (!mesh) {
        // The library calls a file in memory by its format.
        std::string reason = mesh.reason();
        if (const std::string name = "memory." + options.format + ": "; reason.starts_with(name))
            reason.erase(0, name.size());
        throw FileError("standard input: " + reason);
    }
    file.mesh = *std::move(mesh);
    return file;
}

void print_mesh(const Mesh& mesh, const std::string& format)
{
    const Result<FileBytes> file = mesh_file_bytes(mesh, format.c_str());
    if (!file) throw FileError(std::string("standard output: ") + file.reason());
    const std::span<const std::byte> bytes = file->bytes();
    print(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace kerf::tools
