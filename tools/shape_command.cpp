#include <kerf/shapes.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line/whole_number.h"
#include "tools/commands.h"
#include "tools/mesh_files.h"
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
    kerf::ShapeOptions how;
    how.seed = options.seed;
    const Result<Mesh> shape = make_shape(options.name.c_str(), options.triangles, how);
    if (!shape) throw std::runtime_error(options.name + ": " + shape.reason());
    check(write_mesh(*shape, options.out.c_str()));
    print(options.out + ": " + counted(shape->triangle_count(), "triangle") + "\n");
}

std::vector<std::string> shape_names()
{
    std::vector<std::string> names;
    for (std::size_t i = 0; const char* name = shape_name(i); ++i) names.emplace_back(name);
    return names;
}

std::string list_of_names()
{
    std::string list;
    for (const std::string& name : shape_names()) list += (list.empty() ? "" : ", ") + name;
    return list;
}

}  // namespace

void add_shape_command(CLI::App& program)
{
    auto options = std::make_shared<ShapeOptions>();
    CLI::App* command = program.add_subcommand("shape", "Write a generated shape");
    command->add_option("NAME", options->name, "Which shape; see below")
        ->required()
        ->check(CLI::IsMember(shape_names()).description(""));
    command->add_option("-n,--triangles", options->triangles, "About how many triangles it should have")
        ->transform(command_line::whole_number(1, kMostShapeTriangles))
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
