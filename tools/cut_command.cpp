#include <kerf/cut.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "command_line/whole_number.h"
#include "common/support/stopwatch.h"
#include "tools/commands.h"
#include "tools/cut_batch.h"
#include "tools/cut_jobs.h"
#include "tools/cut_output.h"
#include "tools/cut_report.h"
#include "tools/cut_settings.h"
#include "tools/heights.h"
#include "tools/in_order.h"
#include "tools/input.h"
#include "tools/mesh_info.h"
#include "tools/registry.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct CutCommandOptions
{
    InputOptions input;
    CutSettings cut;
    std::string backend = backend_families().front().name;
    std::string lookup;
    std::string prefix;
    std::string format = writable_formats().front();
    std::optional<Side> keep;
    BatchOptions batch;
    bool must_cut = false;
    bool json = false;

    CutOutput output() const { return {prefix, format, keep, {}}; }
};

/// What is said of a mesh that was read, before it is cut.
CutReport report_of(const LoadedFile& loaded, const CutCommandOptions& options)
{
    CutReport report;
    report.file = options.input.file;
    report.backend = full_name(options.backend, options.lookup);
    for (const BackendFamily& entry : backend_families())
        if (entry.name == family_of(options.backend)) report.closes_with_fan = entry.closes_with_fan;
    report.repairs = describe(loaded.repairs()).c_str();
    report.notes = notes_json(loaded.report);
    report.note_texts = notes_text(loaded.report);
    report.has_coarse_coordinates = loaded.mesh.has_coarse_coordinates();
    return report;
}

Object prepared(Mesh mesh, const CutReport& report)
{
    PrepareOptions options;
    options.back_end_name = report.backend.c_str();
    Result<Object> object = prepare(std::move(mesh), options);
    if (!object) throw std::runtime_error(report.file + ": " + object.reason());
    return *std::move(object);
}

/// The side that is kept, to the standard output.
void print_side(Cut& cut, const CutCommandOptions& options)
{
    const Object* const piece = cut.one(*options.keep);
    if (piece == nullptr) throw std::runtime_error(options.input.file + ": nothing is left on the side that is kept");
    print_mesh(mesh_of(*piece), options.format);
}

CutReport perform(const CutCommandOptions& options)
{
    LoadedFile loaded = load_input(options.input);
    CutReport report = report_of(loaded, options);
    report.plane = options.cut.plane_in(loaded.mesh.bounds());
    report.has_gap = options.cut.gap > 0.0;

    core::Stopwatch watch;
    Object object = prepared(std::move(loaded.mesh), report);
    report.prepare_ms = watch.lap();
    Cut result = cut(std::move(object), report.plane, options.cut.options());
    report.cut_ms = watch.lap();
    report.take(result);
    if (result.status == Status::missed) return report;
    if (!ok(result.status)) throw std::runtime_error(report.file + ": " + result.reason());

    if (options.prefix == "-") {
        print_side(result, options);
        return report;
    }
    MeshFileSet files(loaded.report);
    add_pieces(files, options.output(), options.cut.components, result, report);
    check(files.commit());
    return report;
}

std::string list_of_backends()
{
    std::string list;
    for (const BackendFamily& backend : backend_families()) {
        list += "  " + backend.name + "  " + backend.description + "\n";
        if (!backend.lookups.empty()) list += "    lookups, also as " + backend.name + "/LOOKUP: ";
        for (std::size_t i = 0; i < backend.lookups.size(); ++i)
            list += backend.lookups[i] + (i + 1 < backend.lookups.size() ? ", " : "\n");
    }
    return list;
}

/// Who asks for a lookup, even for one that does not exist, wants a back end that has some.
std::string backend_with_lookups()
{
    for (const BackendFamily& backend : backend_families())
        if (!backend.lookups.empty()) return backend.name;
    return backend_families().front().name;
}

void run_batch(const CutCommandOptions& options)
{
    const std::vector<CutJob> jobs = read_jobs(options.batch.jobs, options.cut);
    LoadedFile loaded = load_input(options.input);
    const CutReport report = report_of(loaded, options);
    const std::uint64_t key = key_of(loaded.mesh);
    const Box bounds = loaded.mesh.bounds();
    const Object object = prepared(std::move(loaded.mesh), report);
    CutOutput output = options.output();
    output.kept_files = {options.batch.jobs, options.batch.results};
    std::erase(output.kept_files, "");
    run_jobs({jobs, object, bounds, key, loaded.report, report, output}, options.batch, options.must_cut);
}

void run(const CutCommandOptions& options)
{
    const CutReport report = perform(options);
    if (options.json) {
        Json json = cut_json(report);
        json["time_ms"] = times_json(report);
        print(json);
    } else if (options.prefix != "-") {
        print(cut_text(report));
    }
    if (options.must_cut && report.status == Status::missed)
        throw NothingToCut(report.file + ": the plane does not divide it");
}

/// What the standard streams can't do.
void check_output(const CutCommandOptions& options)
{
    if (options.batch.jobs == "-" && options.input.file == "-")
        throw CLI::ValidationError("--batch", "the standard input is the mesh, or the jobs");
    if (options.prefix != "-") return;
    if (!options.keep)
        throw CLI::ValidationError("--out", "the standard output takes one mesh: say --keep positive or negative");
    if (options.cut.components || options.json || !options.batch.jobs.empty())
        throw CLI::ValidationError("--out", "the standard output takes one mesh, and nothing besides");
}

}  // namespace

void add_cut_command(CLI::App& program)
{
    auto options = std::make_shared<CutCommandOptions>();
    CLI::App* command = program.add_subcommand("cut", "Cut a mesh by a plane and write both sides");
    add_input_options(*command, options->input);
    CLI::Option* point =
        command
            ->add_option_function<std::string>(
                "--point", [options](const std::string& text) { options->cut.point = parse_point("--point", text); },
                "A point of the plane, each coordinate rounded to float as in the mesh; default: the centre of the "
                "mesh's bounds")
            ->type_name("X,Y,Z");
    CLI::Option* normal = command
                              ->add_option_function<std::string>(
                                  "--normal",
                                  [options](const std::string& text) {
                                      options->cut.normal = parse_vector("--normal", text);
                                      if (!Plane::at(Point(0, 0, 0), Normal(*options->cut.normal)))
                                          throw CLI::ValidationError("--normal", "'" + text + "' has no direction");
                                  },
                                  "The plane's normal, of any length; it points to the positive side")
                              ->type_name("X,Y,Z");
    command
        ->add_option_function<std::string>(
            "--plane", [options](const std::string& text) { options->cut.plane = parse_axis_plane("--plane", text); },
            "A plane across an axis instead, such as x=0.5; its normal points along the axis, with --plane=-x=0.5 "
            "against it")
        ->type_name("AXIS=NUMBER")
        ->excludes(point)
        ->excludes(normal);
    CLI::Option* plane = command->get_option("--plane");
    command
        ->add_option_function<std::vector<std::string>>(
            "--through",
            [options](const std::vector<std::string>& points) {
                options->cut.plane = parse_plane_through("--through", points);
            },
            "A plane through three points instead; they run counter-clockwise if they are seen from its positive side")
        ->type_name("X,Y,Z X,Y,Z X,Y,Z")
        ->expected(3)
        ->excludes(point)
        ->excludes(normal)
        ->excludes(plane);
    command
        ->add_option_function<std::string>(
            "--gap", [options](const std::string& text) { options->cut.gap = parse_width("--gap", text); },
            "Width of the blade, in the mesh's unit: what lies within half of it is taken away")
        ->type_name("NUMBER");
    CLI::Option* gap = command->get_option("--gap");
    const auto only = [&](const char* name, OnlyNear::Extent extent, const char* description) {
        return command
            ->add_option_function<std::string>(
                name,
                [options, name, extent](const std::string& text) {
                    const glm::dvec3 p = parse_point(name, text);
                    options->cut.only = OnlyNear{{p.x, p.y, p.z}, extent};
                },
                description)
            ->type_name("X,Y,Z")
            ->excludes(gap);
    };
    CLI::Option* region =
        only("--only", OnlyNear::Extent::region,
             "Cut the region of the section alone that is nearest to this point; the rest stays whole");
    only("--only-solid", OnlyNear::Extent::solid, "Cut the solid alone whose section is nearest to this point")
        ->excludes(region);
    CLI::Option* backend = command->add_option("--backend", options->backend, "Which way to cut; see below")
                               ->check(CLI::IsMember(backend_choices()).description(""))
                               ->capture_default_str();
    CLI::Option* lookup = command->add_option("--lookup", options->lookup,
                                              "How the baseline, which this implies, looks up vertices; see below");
    command->add_flag_callback(
        "--no-cap", [options] { options->cut.cap = false; }, "Leave the section open");
    command
        ->add_option_function<std::string>(
            "--cap-quality",
            [options](const std::string& text) {
                options->cut.cap_quality = text == "delaunay" ? CapQuality::delaunay : CapQuality::fast;
                if (!has_cap_quality(options->cut.cap_quality))
                    throw CLI::ValidationError("--cap-quality",
                                               "this kerf was built without CGAL, which delaunay needs");
            },
            "Triangles of the caps: fast, or delaunay, which has no needles but where the outline forces them")
        ->check(CLI::IsMember({"fast", "delaunay"}).description(""))
        ->default_str("fast");
    command->add_flag("--components", options->cut.components, "Write the connected pieces of each side one by one");
    command
        ->add_option("--out", options->prefix,
                     "Beginning of the names of the files to write; with --keep, - is the standard output")
        ->type_name("PREFIX")
        ->check(CLI::Validator(
            [](const std::string& prefix) {
                const bool has_name = !std::filesystem::path(prefix).filename().empty();
                return has_name ? std::string()
                                : "'" + prefix + "' names no file; put the beginning of a name at its end";
            },
            ""))
        ->required();
    CLI::Option* format =
        command->add_option("--format", options->format, "Format of the files: obj, ply, stl, off or glb")
            ->check(CLI::IsMember(writable_formats()).description(""))
            ->capture_default_str();
    command
        ->add_option_function<std::string>(
            "--keep",
            [options](const std::string& side) {
                options->keep = side == "positive" ? Side::positive : Side::negative;
            },
            "Write one side alone: positive or negative")
        ->check(CLI::IsMember({"positive", "negative"}).description(""))
        ->type_name("SIDE");
    CLI::Option* batch = command->add_option(
        "--batch", options->batch.jobs, "Make many cuts of the mesh, a job a line; see below. - is the standard input");
    batch->type_name("JOBS")->excludes(point)->excludes(normal)->excludes(plane)->excludes(
        command->get_option("--through"));
    command
        ->add_option(
            "--results", options->batch.results,
            "File of the batch's lines; if it is there, the batch goes on behind them. Default: standard output")
        ->type_name("FILE")
        ->needs(batch);
    command
        ->add_option("-j,--jobs", options->batch.threads,
                     "How many cuts of a batch at once; 0: as many as the processor has")
        ->transform(command_line::whole_number(0, kMostThreads))
        ->capture_default_str()
        ->needs(batch);
    command->add_flag("--require-cut", options->must_cut, "Exit status 3 if a plane misses");
    command->add_flag("--json", options->json, "Print JSON instead of text");
    command->footer(
        "Writes PREFIX.positive.obj and PREFIX.negative.obj, with --components PREFIX.positive.0.obj and so on:\n"
        "all of them or, when something goes wrong, none. A plane that misses writes nothing.\n\n"
        "Back ends:\n" +
        list_of_backends() +
        "\nA batch reads the mesh once. Each line of JOBS is a JSON object: one of \"plane\": \"z=0.5\", \"normal\":\n"
        "[0, 0, 1] with \"point\": [0, 0, 0.5], and \"through\": three points; and, if it differs from the options "
        "here,\n"
        "\"gap\", \"cap\", \"components\", \"only\", \"only_solid\". Its files are PREFIX.NAME.positive.obj and so on; "
        "NAME is\n"
        "\"name\", or the number of the job. A line of JSON is printed for each, in order.\n"
        "\nExamples:\n"
        "  kerf cut rook.obj --normal 0,1,0 --out /tmp/rook\n"
        "  kerf cut rook.obj --plane y=0.5 --out /tmp/rook\n"
        "  kerf cut rook.obj --through 0,0,0 1,0,0 0,1,1 --gap 0.1 --out /tmp/rook\n"
        "  kerf cut knot.off --point 0.1,0,0 --normal 1,0.5,0 --components --format ply --out knot --json\n"
        "  kerf cut - --from stl --plane z=10 --keep negative --out - --format stl < part.stl > lower.stl\n"
        "  kerf cut part.stl --batch jobs.jsonl --results done.jsonl -j 0 --format ply --out cuts/part");
    command->callback([options, backend, lookup, batch, format] {
        if (!options->cut.has_plane() && batch->empty())
            throw CLI::RequiredError("--normal, --plane, --through or --batch");
        if (!format->empty()) take_format(options->input, options->format);
        check_input(options->input);
        check_output(*options);
        if (backend->empty() && !lookup->empty()) options->backend = backend_with_lookups();
        try {
            static_cast<void>(full_name(options->backend, options->lookup));
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError("--lookup", error.what());
        }
        if (batch->empty())
            run(*options);
        else
            run_batch(*options);
    });
}

}  // namespace kerf::tools
