#include <kerf/dice.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/support/stopwatch.h"
#include "tools/commands.h"
#include "tools/dice_planes.h"
#include "tools/flat_mesh.h"
#include "tools/fragment_facts.h"
#include "tools/heights.h"
#include "tools/input.h"
#include "tools/mesh_info.h"
#include "tools/progress_line.h"
#include "tools/registry.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct DiceCommandOptions
{
    InputOptions input;
    std::optional<glm::uvec3> grid;
    std::optional<glm::dvec3> size;
    std::string planes_file;
    double gap = 0.0;
    bool no_cap = false;
    bool components = false;
    std::string prefix;
    std::string format = writable_formats().front();
    std::string backend;
    bool must_cut = false;
    bool json = false;
};

/// One piece that was written.
struct WrittenPiece
{
    std::string file;
    std::vector<std::uint32_t> cell;
    FragmentFacts facts;
};

struct DiceReport
{
    std::string file, backend;
    Status status = Status::done;
    FileReport read;
    std::vector<WrittenPiece> pieces;
    std::uint64_t empty_cells = 0;
    bool caps_exceed_section = false;
    double prepare_ms = 0.0, dice_ms = 0.0;

    FragmentFacts total() const
    {
        FragmentFacts sum;
        for (const WrittenPiece& piece : pieces) sum.add(piece.facts);
        return sum;
    }
};

PlaneFamilies families_of(const DiceCommandOptions& options, const Box& bounds)
{
    if (options.grid) return grid_of(bounds, *options.grid);
    if (options.size) return grid_of(bounds, layers_of_size(bounds, *options.size));
    return read_planes(options.planes_file);
}

Object prepared(Mesh mesh, const DiceCommandOptions& options, const PlaneFamilies& families)
{
    PrepareOptions prepare_options;
    prepare_options.back_end_name = options.backend.empty() ? nullptr : options.backend.c_str();
    prepare_options.cuts_expected = cuts_expected(families.planes());
    prepare_options.threads = 0;
    Result<Object> object = prepare(std::move(mesh), prepare_options);
    if (!object) throw std::runtime_error(options.input.file + ": " + object.reason());
    return *std::move(object);
}

Dice diced(Object&& object, const DiceCommandOptions& options, const PlaneFamilies& families)
{
    ProgressLine line("dice");
    DiceOptions dice_options;
    dice_options.cut.gap = options.gap;
    dice_options.cut.cap = !options.no_cap;
    dice_options.cut.components = options.components;
    dice_options.user = &line;
    dice_options.progress = [](void* user, double share) {
        static_cast<ProgressLine*>(user)->show(share);
        return true;
    };
    Dice dice = kerf::dice(std::move(object), families.planes(), dice_options);
    if (!ok(dice.status())) throw std::runtime_error(options.input.file + ": " + dice.reason());
    return dice;
}

/// PREFIX.0-2-1.obj: the layers of the cell, or the number of the piece if there are more than three; with components the
/// number of the piece in its cell besides.
std::string file_name(const DiceCommandOptions& options, Dice& dice, std::size_t number, std::size_t in_cell)
{
    std::string name = options.prefix + ".";
    const auto cell = dice.cell(number);
    if (cell.size() > 3) {
        name += std::to_string(number);
    } else {
        for (std::size_t i = 0; i < cell.size(); ++i) {
            if (i > 0) name += "-";
            name += std::to_string(cell[i]);
        }
        if (options.components) name.append(".").append(std::to_string(in_cell));
    }
    return name + "." + options.format;
}

void write(const DiceCommandOptions& options, Dice& dice, DiceReport& report)
{
    MeshFileSet files(report.read);
    std::size_t in_cell = 0;
    for (std::size_t i = 0; i < dice.count(); ++i) {
        in_cell = i > 0 && std::ranges::equal(dice.cell(i), dice.cell(i - 1)) ? in_cell + 1 : 0;
        const Mesh mesh = mesh_of(*dice.piece(i));
        const std::string name = file_name(options, dice, i, in_cell);
        check(files.add(name.c_str(), mesh));
        const auto cell = dice.cell(i);
        report.pieces.push_back(
            {name, {cell.begin(), cell.end()}, measure_fragment(flat(mesh), dice.piece(i)->mass_properties())});
    }
    check(files.commit());
}

Json report_json(const DiceReport& report)
{
    Json warnings = Json::array();
    if (report.caps_exceed_section) warnings.push_back("caps_exceed_section");
    Json json{{"file", report.file},
              {"backend", report.backend},
              {"status", outcome_name(report.status)},
              {"repairs", describe(report.read.mesh().repairs).c_str()},
              {"warnings", std::move(warnings)},
              {"notes", notes_json(report.read)}};
    json.update(facts_json(report.total()));
    json["empty_cells"] = report.empty_cells;
    json["pieces"] = Json::array();
    for (const WrittenPiece& piece : report.pieces) {
        Json entry{{"file", piece.file}, {"cell", piece.cell}};
        entry.update(facts_json(piece.facts));
        json["pieces"].push_back(std::move(entry));
    }
    json["time_ms"] = {{"prepare", report.prepare_ms}, {"dice", report.dice_ms}};
    return json;
}

std::string report_text(const DiceReport& report)
{
    std::string said;
    for (const std::string& note : notes_text(report.read)) said.append("note: ").append(note).append("\n");
    if (const Sentence repairs = describe(report.read.mesh().repairs); !repairs.is_empty())
        said.append("repaired: ").append(repairs.c_str()).append("\n");
    said.append(counted(report.pieces.size(), "piece")).append(", ").append(facts_text(report.total()));
    if (report.empty_cells > 0) said.append("; ").append(counted(report.empty_cells, "empty cell"));
    said += "\n";
    if (report.status == Status::open_section) said += "the mesh is open: some sections have no cap\n";
    if (report.caps_exceed_section) said += "warning: some caps have more area than their sections\n";
    constexpr std::size_t kMostNames = 10;
    for (std::size_t i = 0; i < std::min(report.pieces.size(), kMostNames); ++i)
        said.append("  ").append(report.pieces[i].file).append("\n");
    if (report.pieces.size() > kMostNames)
        said.append("  and ").append(grouped(report.pieces.size() - kMostNames)).append(" more\n");
    return said.append(report.backend)
        .append(": prepare ")
        .append(rounded(report.prepare_ms))
        .append(" ms, dice ")
        .append(rounded(report.dice_ms))
        .append(" ms\n");
}

void run(const DiceCommandOptions& options)
{
    LoadedFile loaded = load_input(options.input);
    const PlaneFamilies families = families_of(options, loaded.mesh.bounds());
    DiceReport report;
    report.file = options.input.file;
    core::Stopwatch watch;
    Object object = prepared(std::move(loaded.mesh), options, families);
    report.prepare_ms = watch.lap();
    report.backend = object.back_end_name();
    Dice dice = diced(std::move(object), options, families);
    report.dice_ms = watch.lap();
    report.read = std::move(loaded.report);
    report.status = dice.status();
    report.empty_cells = dice.empty_cells();
    report.caps_exceed_section = dice.caps_exceed_section();
    write(options, dice, report);
    if (options.json)
        print(report_json(report));
    else
        print(report_text(report));
    if (options.must_cut && dice.statistics().crossing_triangles == 0)
        throw NothingToCut(report.file + ": no plane goes through it");
}

}  // namespace

void add_dice_command(CLI::App& program)
{
    auto options = std::make_shared<DiceCommandOptions>();
    CLI::App* command = program.add_subcommand("dice", "Cut a mesh into cells and write a file for each");
    add_input_options(*command, options->input);
    CLI::Option* grid =
        command
            ->add_option_function<std::string>(
                "--grid", [options](const std::string& text) { options->grid = parse_grid("--grid", text); },
                "So many cells along x, y and z")
            ->type_name("AxBxC");
    CLI::Option* size =
        command
            ->add_option_function<std::string>(
                "--size", [options](const std::string& text) { options->size = parse_size("--size", text); },
                "Cells that are all of one size along an axis, and no larger; 0 does not divide it")
            ->type_name("X,Y,Z");
    CLI::Option* planes =
        command->add_option("--planes", options->planes_file,
                            "File of planes, a line each: the normal and the distance from the origin along it");
    for (CLI::Option* one : {grid, size, planes})
        for (CLI::Option* other : {grid, size, planes})
            if (one != other) one->excludes(other);
    command
        ->add_option_function<std::string>(
            "--gap", [options](const std::string& text) { options->gap = parse_width("--gap", text); },
            "Width of the blade, in the mesh's unit: what lies within half of it is taken away")
        ->type_name("NUMBER");
    command->add_flag("--no-cap", options->no_cap, "Leave the sections open");
    command->add_flag("--components", options->components, "Write the connected pieces of each cell one by one");
    command->add_option("--out", options->prefix, "Beginning of the names of the files to write")
        ->type_name("PREFIX")
        ->required();
    command->add_option("--format", options->format, "Format of the files: obj, ply, stl, off or glb")
        ->check(CLI::IsMember(writable_formats()).description(""))
        ->capture_default_str();
    command
        ->add_option("--backend", options->backend, "Which way to cut; default: the one that pays for so many planes")
        ->check(CLI::IsMember(backend_choices()).description(""));
    command->add_flag("--require-cut", options->must_cut, "Exit status 3 if no plane goes through the mesh");
    command->add_flag("--json", options->json, "Print JSON instead of text");
    command->footer(
        "Writes PREFIX.0-2-1.obj and so on, by the layers of the cell along x, y and z; PREFIX.0.obj and so on for "
        "more\n"
        "than three planes from a file. All of them or, when something goes wrong, none. Empty cells have no file.\n\n"
        "Examples:\n"
        "  kerf dice rook.obj --grid 2x3x2 --out /tmp/rook\n"
        "  kerf dice large.stl --size 200,200,180 --gap 0.2 --format stl --out parts/large");
    command->callback([options, grid, size, planes] {
        if (grid->empty() && size->empty() && planes->empty()) throw CLI::RequiredError("--grid, --size or --planes");
        check_input(options->input);
        if (!options->backend.empty()) options->backend = full_name(options->backend);
        run(*options);
    });
}

}  // namespace kerf::tools
