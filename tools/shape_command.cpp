#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "command_line/whole_number.h"
#include "common/io/mesh_file.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "tools/commands.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct ShapeOptions
{
    std::string name;
    std::uint64_t triangles = 10'000;
    std::uint64_t seed = 1;
    std::string out;
};

void run(const ShapeOptions& options)
{
    std::optional<TriangleSoup> soup = shapes::make(options.name, options.triangles, options.seed);
    if (!soup) throw std::runtime_error("there is no shape called '" + options.name + "'");
    const Repaired repaired = repair(std::move(*soup));
    if (!repaired.error.empty()) throw std::runtime_error(options.name + ": " + repaired.error);
    io::write_mesh(options.out, repaired.mesh);
    print(options.out + ": " + counted(repaired.mesh->triangles.size(), "triangle") + "\n");
}

std::string list_of_names()
{
    std::string list;
    for (const std::string& name : shapes::names()) list += (list.empty() ? "" : ", ") + name;
    return list;
}

}  // namespace

void add_shape_command(CLI::App& program)
{
    auto options = std::make_shared<ShapeOptions>();
    CLI::App* command = program.add_subcommand("shape", "Write a generated shape");
    command->add_option("NAME", options->name, "Which shape; see below")
        ->required()
        ->check(CLI::IsMember(shapes::names()).description(""));
    command->add_option("-n,--triangles", options->triangles, "About how many triangles it should have")
        ->transform(command_line::whole_number(1, shapes::kMostTriangles))
        ->capture_default_str();
    command->add_option("-s,--seed", options->seed, "Another seed gives another asteroid")
        ->transform(command_line::whole_number())
        ->capture_default_str();
    command->add_option("-o,--out", options->out, "File to write: obj, ply, stl, off or glb")
        ->required()
        ->type_name("FILE");
    command->footer("Shapes: " + list_of_names() +
                    ".\n\n"
                    "Examples:\n"
                    "  kerf shape asteroid --triangles 100000 --seed 7 -o rock.ply\n"
                    "  kerf shape menger_sponge --triangles 20000 -o sponge.glb");
    command->callback([options] { run(*options); });
}

}  // namespace kerf::tools
