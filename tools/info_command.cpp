#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "command_line/whole_number.h"
#include "tools/commands.h"
#include "tools/flat_mesh.h"
#include "tools/in_order.h"
#include "tools/input.h"
#include "tools/mesh_info.h"
#include "tools/progress_line.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct InfoOptions
{
    std::vector<std::string> files;
    std::string format;  ///< of the standard input
    bool json = false, jsonl = false;
    unsigned threads = 1;
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

/// What is printed of a file, or why it is none.
struct Said
{
    std::string text, failure;
};

Said said_of(const std::string& file, const InfoOptions& options)
{
    Said said;
    try {
        const LoadedFile loaded = load_input({file, options.format});
        if (options.jsonl)
            said.text = line_text(info_json(loaded, file));
        else if (options.json)
            said.text = document_text(info_json(loaded, file));
        else
            said.text = info_text(loaded, file);
    } catch (const FileError& error) {
        said.failure = error.what();
        if (options.jsonl) said.text = line_text({{"file", file}, {"error", said.failure}});
    }
    return said;
}

/// One file: a failure is that of the program. Several: the others are looked at all the same.
void run(const InfoOptions& options)
{
    const std::size_t count = options.files.size();
    std::size_t failed = 0;
    ProgressLine progress("files");
    in_order(
        count, thread_count(options.threads), [&](std::size_t i) { return said_of(options.files[i], options); },
        [&](std::size_t i, const Said& said) {
            if (!said.failure.empty() && count == 1 && !options.jsonl) throw FileError(said.failure);
            if (!said.failure.empty() && !options.jsonl) complain(said.failure);
            failed += !said.failure.empty();
            print(said.text);
            progress.show(double(i + 1) / double(count));
        });
    if (failed > 0) throw FileError(grouped(failed) + " of " + counted(count, "file") + " can't be used");
}

}  // namespace

void add_info_command(CLI::App& program)
{
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = program.add_subcommand("info", "Say what a mesh file is like, and what would be repaired");
    command->add_option("FILE", options->files, "Meshes: obj, ply, stl, off, gltf or glb; - reads the standard input")
        ->required();
    command->add_option("--from,--format", options->format, "Format of the standard input");
    CLI::Option* json = command->add_flag("--json", options->json, "Print JSON instead of text");
    command
        ->add_flag("--jsonl", options->jsonl, "Print a line of JSON for each file; what can't be used has an \"error\"")
        ->excludes(json);
    command->add_option("-j,--jobs", options->threads, "How many files at once; 0: as many as the processor has")
        ->transform(command_line::whole_number(0, kMostThreads))
        ->capture_default_str();
    command->footer(
        "Facts are those of the file, before anything is repaired; vertices are welded where their positions are "
        "equal. Closed is what has no boundary once it is repaired.\n\n"
        "Examples:\n"
        "  kerf info rook.obj\n"
        "  kerf info scan.ply --json | jq .volume\n"
        "  kerf info parts/*.stl --jsonl -j 0 > parts.jsonl\n"
        "  curl -s https://example.org/part.stl | kerf info - --format stl");
    command->callback([options] {
        for (const std::string& file : options->files) check_input({file, options->format});
        if (std::count(options->files.begin(), options->files.end(), "-") > 1)
            throw CLI::ValidationError("FILE", "the standard input is one mesh");
        if (options->json && options->files.size() > 1)
            throw CLI::ValidationError("--json", "one document for each file: say --jsonl");
        run(*options);
    });
}

}  // namespace kerf::tools
