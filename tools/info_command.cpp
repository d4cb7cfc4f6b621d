#include <filesystem>
#include <memory>
#include <string>

#include "tools/commands.h"
#include "tools/flat_mesh.h"
#include "tools/mesh_info.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct InfoOptions
{
    std::string file;
    bool json = false;
};

Json info_json(const LoadedFile& loaded, const std::string& file)
{
    const MeshFacts& facts = loaded.facts();
    Json warnings = Json::array();
    if (facts.has_coarse_coordinates) warnings.push_back("coarse_coordinates");
    Json materials = Json::array(), streams = Json::array();
    for (std::size_t i = 0; i < loaded.mesh.material_count(); ++i) materials.push_back(loaded.mesh.material(i).name);
    for (std::size_t i = 0; i < loaded.mesh.stream_count(); ++i) {
        const Stream stream = loaded.mesh.stream(i);
        streams.push_back(Json{{"name", stream.name}, {"width", stream.width}});
    }
    return {{"file", file},
            {"triangles", facts.triangles},
            {"vertices", facts.vertices},
            {"welded_vertices", facts.points},
            {"closed", facts.is_closed()},
            {"manifold", facts.is_manifold()},
            {"oriented", facts.is_oriented()},
            {"shells", facts.shells},
            {"boundary_edges", facts.boundary_edges},
            {"boundary_loops", facts.boundary_loops},
            {"nonmanifold_edges", facts.nonmanifold_edges},
            {"nonmanifold_points", facts.nonmanifold_points},
            {"misoriented_edges", facts.misoriented_edges},
            {"degenerate_triangles", facts.degenerate_triangles},
            {"duplicate_triangles", facts.duplicate_triangles},
            {"unbalanced_edges", facts.unbalanced_edges},
            {"open_edges", facts.open_edges},
            {"shortest_edge", facts.shortest_edge},
            {"warnings", std::move(warnings)},
            {"notes", notes_json(loaded.report)},
            {"area", facts.area},
            {"volume", facts.volume},
            {"bounds",
             {{"min", vector_json(glm::dvec3(to_glm(facts.bounds.lo)))},
              {"max", vector_json(glm::dvec3(to_glm(facts.bounds.hi)))}}},
            {"materials", std::move(materials)},
            {"streams", std::move(streams)},
            {"repairs", repairs_json(loaded.repairs())}};
}

std::string info_text(const LoadedFile& loaded, const std::string& file)
{
    const MeshFacts& facts = loaded.facts();
    const auto line = [](const std::string& name, const std::string& value) {
        return "  " + name + std::string(17 - name.size(), ' ') + value + "\n";
    };
    const auto yes_or = [](bool yes, const std::string& otherwise) { return yes ? "yes" : "no (" + otherwise + ")"; };

    std::string text = file + "\n";
    text += line("triangles", grouped(facts.triangles));
    text += line("vertices", grouped(facts.vertices));
    text += line("welded vertices", grouped(facts.points));
    text += line("closed",
                 yes_or(facts.is_closed(), facts.boundary_edges > 0 ? counted(facts.boundary_edges, "boundary edge") +
                                                                          " in " + counted(facts.boundary_loops, "loop")
                                                                    : counted(facts.open_edges, "triangle side") +
                                                                          " without a neighbour after repair"));
    text += line("manifold", yes_or(facts.is_manifold(), counted(facts.nonmanifold_edges, "edge") + " and " +
                                                             counted(facts.nonmanifold_points, "point") + " are not"));
    text += line("oriented", yes_or(facts.is_oriented(), counted(facts.misoriented_edges, "edge") +
                                                             " with both triangles in one direction"));
    text += line("shells", grouped(facts.shells));
    text += line("boundary loops", grouped(facts.boundary_loops));
    text += line("area", rounded(facts.area));
    text += line("volume", rounded(facts.volume));
    text += line("bounds", vector_text(glm::dvec3(to_glm(facts.bounds.lo))) + " to " +
                               vector_text(glm::dvec3(to_glm(facts.bounds.hi))));
    text += line("shortest edge", rounded(facts.shortest_edge));
    const Sentence repairs = describe(loaded.repairs());
    text += line("repairs", repairs.is_empty() ? "none" : repairs.c_str());
    std::string notes;
    for (const std::string& note : notes_text(loaded.report)) notes += (notes.empty() ? "" : ", ") + note;
    if (!notes.empty()) text += line("notes", notes);
    if (facts.has_coarse_coordinates) text += line("warning", kCoarseCoordinatesText);
    return text;
}

void run(const InfoOptions& options)
{
    const LoadedFile loaded = load(options.file);
    if (options.json)
        print(info_json(loaded, options.file));
    else
        print(info_text(loaded, options.file));
}

}  // namespace

void add_info_command(CLI::App& program)
{
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = program.add_subcommand("info", "Say what a mesh file is like, and what would be repaired");
    command->add_option("FILE", options->file, "Mesh: obj, ply, stl, off, gltf or glb")->required();
    command->add_flag("--json", options->json, "Print JSON instead of text");
    command->footer(
        "Facts are those of the file, before anything is repaired; vertices are welded where their positions are "
        "equal. Closed is what has no boundary once it is repaired.\n\n"
        "Examples:\n"
        "  kerf info rook.obj\n"
        "  kerf info scan.ply --json | jq .volume");
    command->callback([options] { run(*options); });
}

}  // namespace kerf::tools
