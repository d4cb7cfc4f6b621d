#include <kerf/fracture.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/support/stopwatch.h"
#include "tools/commands.h"
#include "tools/fracture_scene.h"
#include "tools/heights.h"
#include "tools/input.h"
#include "tools/mesh_info.h"
#include "tools/progress_line.h"
#include "tools/registry.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

const std::map<std::string, FracturePattern>& patterns()
{
    static const std::map<std::string, FracturePattern> all{{"uniform", FracturePattern::uniform},
                                                            {"impact", FracturePattern::impact},
                                                            {"crack", FracturePattern::crack},
                                                            {"grid", FracturePattern::grid},
                                                            {"splinters", FracturePattern::splinters}};
    return all;
}

struct FractureCommandOptions
{
    InputOptions input;
    std::string pattern = "uniform";
    std::uint32_t cells = 50;
    std::uint64_t seed = 0;
    std::optional<glm::dvec3> at, direction;
    double least_volume = 0.0, explode = 0.0;
    std::string out, backend;
    bool json = false;
};

Object prepared(Mesh mesh, const FractureCommandOptions& options)
{
    PrepareOptions prepare_options;
    // Pieces that are only written need not be ready for cuts.
    prepare_options.back_end_name = options.backend.empty() ? "linear" : options.backend.c_str();
    Result<Object> object = prepare(std::move(mesh), prepare_options);
    if (!object) throw std::runtime_error(options.input.file + ": " + object.reason());
    return *std::move(object);
}

Fracture broken(const Object& object, const FractureCommandOptions& options)
{
    ProgressLine line("fracture");
    FractureOptions how;
    how.pattern = patterns().at(options.pattern);
    how.cells = options.cells;
    how.seed = options.seed;
    if (options.at) how.at = Point(*options.at);
    if (options.direction) how.direction = Normal(*options.direction);
    how.least_volume = options.least_volume;
    how.user = &line;
    how.progress = [](void* user, double share) {
        static_cast<ProgressLine*>(user)->show(share);
        return true;
    };
    Fracture fracture = kerf::fracture(object, how);
    if (!ok(fracture.status())) throw std::runtime_error(options.input.file + ": " + fracture.reason());
    return fracture;
}

/// Farther away other programs show nothing, and floats tell nothing.
constexpr double kMostExploded = 1000.0;

/// The last of the materials: the inside's, unless the object had one for it.
std::string material_inside(Fracture& fracture)
{
    for (std::size_t i = 0; const Object* const piece = fracture.piece(i); ++i)
        if (piece->material_count() > 0) return piece->material(piece->material_count() - 1).name;
    return {};
}

struct FractureReport
{
    std::string file, backend;
    FileReport read;
    std::vector<FracturePiece> pieces;
    std::vector<FractureBond> bonds;
    std::string material;
    double prepare_ms = 0.0, fracture_ms = 0.0;

    FragmentFacts total() const
    {
        FragmentFacts sum;
        for (const FracturePiece& piece : pieces) sum.add(piece.facts);
        return sum;
    }
};

Json report_json(const FractureCommandOptions& options, const FractureReport& report)
{
    Json json{{"file", report.file},
              {"backend", report.backend},
              {"repairs", describe(report.read.mesh().repairs).c_str()},
              {"notes", notes_json(report.read)},
              {"pattern", options.pattern},
              {"cells", options.cells},
              {"seed", options.seed}};
    json.update(facts_json(report.total()));
    json["interior_material"] = report.material;
    json["pieces"] = Json::array();
    for (const FracturePiece& piece : report.pieces) {
        Json entry{{"name", piece.name}, {"cells", piece.cells}};
        entry.update(facts_json(piece.facts));
        json["pieces"].push_back(std::move(entry));
    }
    json["contacts"] = Json::array();
    for (const FractureBond& bond : report.bonds) json["contacts"].push_back(contact_json(bond));
    json["time_ms"] = {{"prepare", report.prepare_ms}, {"fracture", report.fracture_ms}};
    return json;
}

std::string report_text(const FractureReport& report)
{
    std::string said;
    for (const std::string& note : notes_text(report.read)) said.append("note: ").append(note).append("\n");
    if (const Sentence repairs = describe(report.read.mesh().repairs); !repairs.is_empty())
        said.append("repaired: ").append(repairs.c_str()).append("\n");
    double least = INFINITY, most = 0.0, contact_area = 0.0;
    for (const FracturePiece& piece : report.pieces) {
        least = std::min(least, piece.facts.volume);
        most = std::max(most, piece.facts.volume);
    }
    for (const FractureBond& bond : report.bonds) contact_area += bond.area;
    return said.append(counted(report.pieces.size(), "piece"))
        .append(" of ")
        .append(rounded(least))
        .append(" to ")
        .append(rounded(most))
        .append(", ")
        .append(counted(report.bonds.size(), "contact"))
        .append(" of ")
        .append(rounded(contact_area))
        .append(" in all\n")
        .append(facts_text(report.total()))
        .append("\n")
        .append(report.backend)
        .append(": prepare ")
        .append(rounded(report.prepare_ms))
        .append(" ms, fracture ")
        .append(rounded(report.fracture_ms))
        .append(" ms\n");
}

void run(const FractureCommandOptions& options)
{
    LoadedFile loaded = load_input(options.input);
    FractureReport report;
    report.file = options.input.file;
    const Box box = loaded.mesh.bounds();
    const glm::dvec3 centre = 0.5 * (to_glm(Vec3d(box.lo)) + to_glm(Vec3d(box.hi)));
    core::Stopwatch watch;
    const Object object = prepared(std::move(loaded.mesh), options);
    report.prepare_ms = watch.lap();
    report.backend = object.back_end_name();
    Fracture fracture = broken(object, options);
    report.fracture_ms = watch.lap();
    report.read = std::move(loaded.report);
    report.pieces = pieces_of(fracture);
    report.bonds.assign(fracture.bonds().begin(), fracture.bonds().end());
    report.material = material_inside(fracture);
    if (!options.out.empty()) {
        const std::string bytes = scene_of(report.pieces, report.bonds, centre, options.explode, report.material);
        MeshFileSet files(report.read);
        check(files.add(options.out.c_str(), std::as_bytes(std::span(bytes))));
        check(files.commit());
    }
    if (options.json)
        print(report_json(options, report));
    else
        print(report_text(report));
}

bool ends_with_glb(std::string name)
{
    std::ranges::transform(name, name.begin(), [](char c) { return 'A' <= c && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return name.ends_with(".glb");
}

}  // namespace

void add_fracture_command(CLI::App& program)
{
    auto options = std::make_shared<FractureCommandOptions>();
    CLI::App* command =
        program.add_subcommand("fracture", "Break a closed mesh into pieces and write them as one scene");
    add_input_options(*command, options->input);
    std::vector<std::string> names;
    for (const auto& [name, pattern] : patterns()) names.push_back(name);
    command
        ->add_option("--cells", options->cells,
                     "How many cells; a cell in several parts of the mesh makes several pieces")
        ->check(CLI::Range(1u, 100'000u))
        ->capture_default_str();
    command
        ->add_option(
            "--pattern", options->pattern,
            "How cells lie: anywhere (uniform), smaller near a point (impact), smaller near a plane (crack), in "
            "rows (grid), long (splinters)")
        ->check(CLI::IsMember(names).description(""))
        ->capture_default_str();
    command
        ->add_option_function<std::string>(
            "--at", [options](const std::string& text) { options->at = parse_vector("--at", text); },
            "The point of an impact, of the plane of a crack, or in the middle of splinters; default: the middle of "
            "the mesh")
        ->type_name("X,Y,Z");
    command
        ->add_option_function<std::string>(
            "--direction",
            [options](const std::string& text) {
                options->direction = parse_vector("--direction", text);
                if (*options->direction == glm::dvec3(0.0))
                    throw CLI::ValidationError("--direction", "it must not be 0,0,0");
            },
            "Across the plane of a crack; along splinters; default: 0,1,0")
        ->type_name("X,Y,Z");
    command->add_option("--seed", options->seed, "Another one, other cells")->capture_default_str();
    command
        ->add_option_function<std::string>(
            "--least-volume",
            [options](const std::string& text) { options->least_volume = parse_width("--least-volume", text); },
            "Join smaller pieces to their largest neighbours; in the mesh's unit, cubed")
        ->type_name("NUMBER");
    command
        ->add_option_function<std::string>(
            "--explode",
            [options](const std::string& text) {
                options->explode = parse_width("--explode", text);
                if (options->explode > kMostExploded)
                    throw CLI::ValidationError("--explode",
                                               text + " is more than a thousand times the size of the mesh");
            },
            "Move each piece away from the middle by so many times its distance from there")
        ->type_name("NUMBER");
    command->add_option("-o,--out", options->out, "GLB file to write, a node for each piece")->type_name("FILE");
    command
        ->add_option(
            "--backend", options->backend,
            "Which back end's objects; the pieces have the same surfaces, and may come in another order; default: "
            "linear, which prepares nothing")
        ->check(CLI::IsMember(backend_choices()).description(""));
    command->add_flag("--json", options->json, "Print JSON instead of text");
    command->footer(
        "Cells are those of points (a Voronoi diagram). The extras of each node say which pieces it touches, over "
        "which\n"
        "area and where, its volume, and the material of the inside.\n\n"
        "Examples:\n"
        "  kerf fracture rook.obj --cells 40 -o /tmp/pieces.glb\n"
        "  kerf fracture vase.glb --pattern impact --at 0.1,0.4,0 --seed 7 --explode 0.2 -o /tmp/vase.glb");
    command->callback([options] {
        check_input(options->input);
        if (!options->out.empty() && !ends_with_glb(options->out))
            throw CLI::ValidationError("--out", options->out + " does not end with .glb");
        if (!options->backend.empty()) options->backend = full_name(options->backend);
        run(*options);
    });
}

}  // namespace kerf::tools
