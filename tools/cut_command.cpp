#include <kerf/cut.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/support/stopwatch.h"
#include "tools/commands.h"
#include "tools/fragment_facts.h"
#include "tools/heights.h"
#include "tools/mesh_info.h"
#include "tools/registry.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct CutCommandOptions
{
    std::string file;
    std::optional<glm::dvec3> point;   ///< default: centre of the bounds
    std::optional<glm::dvec3> normal;  ///< this or the plane
    std::optional<Plane> plane;
    std::string backend = backend_families().front().name;
    std::string lookup;
    bool no_cap = false;
    double gap = 0.0;
    std::optional<OnlyNear> only;
    CapQuality cap_quality = CapQuality::fast;
    bool components = false;
    std::string prefix;
    std::string format = writable_formats().front();
    bool json = false;
};

/// One fragment that was written.
struct Piece
{
    std::string file;
    FragmentFacts facts;
};

struct SideReport
{
    std::vector<Piece> pieces;

    FragmentFacts total() const
    {
        FragmentFacts sum;
        for (const Piece& piece : pieces) sum.add(piece.facts);
        return sum;
    }
};

struct CutReport
{
    std::string file, backend;
    Plane plane = Plane::z(0.0).value();
    bool capped = true;
    bool closes_with_fan = false;
    Status status = Status::missed;
    FileReport read;
    bool has_coarse_coordinates = false;
    CutStatistics statistics;
    double section_area = 0.0;
    bool caps_exceed_section = false;
    double prepare_ms = 0.0, cut_ms = 0.0;
    SideReport positive, negative;
};

/// PREFIX.positive.obj, or PREFIX.positive.0.obj for one of several components.
std::string file_name(const CutCommandOptions& options, const char* side, std::size_t component)
{
    std::string name = options.prefix + "." + side;
    if (options.components) name += "." + std::to_string(component);
    return name + "." + options.format;
}

SideReport add_side(MeshFileSet& files, const CutCommandOptions& options, Cut& cut, Side side)
{
    SideReport report;
    for (std::size_t i = 0; const Object* piece = cut.piece(side, i); ++i) {
        const Mesh mesh = mesh_of(*piece);
        const std::string name = file_name(options, side == Side::positive ? "positive" : "negative", i);
        check(files.add(name.c_str(), mesh));
        report.pieces.push_back({name, measure_fragment(flat(mesh), piece->mass_properties())});
    }
    return report;
}

glm::dvec3 centre_of(const Box& box)
{
    return 0.5 * (glm::dvec3(to_glm(box.lo)) + glm::dvec3(to_glm(box.hi)));
}

CutReport perform(const CutCommandOptions& options)
{
    LoadedFile loaded = load(options.file);
    const std::optional<Plane> plane =
        options.plane
            ? options.plane
            : Plane::at(Point(options.point.value_or(centre_of(loaded.mesh.bounds()))), Normal(*options.normal));
    if (!plane) throw std::runtime_error("the plane's numbers are too large to calculate with");

    CutReport report;
    report.file = options.file;
    report.backend = full_name(options.backend, options.lookup);
    report.plane = *plane;
    report.capped = !options.no_cap;
    for (const BackendFamily& entry : backend_families())
        if (entry.name == family_of(options.backend)) report.closes_with_fan = entry.closes_with_fan;
    report.has_coarse_coordinates = loaded.mesh.has_coarse_coordinates();

    core::Stopwatch watch;
    PrepareOptions prepare_options;
    prepare_options.back_end_name = report.backend.c_str();
    Result<Object> prepared = prepare(std::move(loaded.mesh), prepare_options);
    report.prepare_ms = watch.lap();
    if (!prepared) throw std::runtime_error(options.file + ": " + prepared.reason());

    CutOptions cut_options;
    cut_options.cap = !options.no_cap;
    cut_options.gap = options.gap;
    cut_options.only = options.only;
    cut_options.cap_quality = options.cap_quality;
    cut_options.components = options.components;
    watch.lap();
    Cut result = cut(*std::move(prepared), *plane, cut_options);
    report.cut_ms = watch.lap();
    report.status = result.status;
    report.statistics = result.statistics();
    report.section_area = result.section_area;
    report.caps_exceed_section = result.caps_exceed_section;
    report.read = std::move(loaded.report);
    if (result.status == Status::missed) return report;
    if (result.status != Status::done && result.status != Status::open_section)
        throw std::runtime_error(options.file + ": " + result.reason());

    MeshFileSet files(report.read);
    report.positive = add_side(files, options, result, Side::positive);
    report.negative = add_side(files, options, result, Side::negative);
    check(files.commit());
    return report;
}

Json side_json(const SideReport& side)
{
    Json json = facts_json(side.total());
    json["pieces"] = Json::array();
    for (const Piece& piece : side.pieces) {
        Json entry{{"file", piece.file}};
        entry.update(facts_json(piece.facts));
        json["pieces"].push_back(std::move(entry));
    }
    return json;
}

Json report_json(const CutReport& report)
{
    const CutStatistics& statistics = report.statistics;
    Json phases = Json::object();
    for (std::size_t i = 0; i < kPhaseCount; ++i) phases[text(static_cast<Phase>(i))] = statistics.phase_ms[i];
    phases["pivot"] = 0.0;  // the report's loop over new pivots: only benchmarks run it, but the field is published
    Json warnings = Json::array();
    if (report.has_coarse_coordinates) warnings.push_back("coarse_coordinates");
    if (report.caps_exceed_section) warnings.push_back("caps_exceed_section");
    Json json{{"file", report.file},
              {"backend", report.backend},
              {"status", outcome_name(report.status)},
              {"plane", {{"normal", vector_json(to_glm(report.plane.normal()))}, {"offset", report.plane.offset()}}},
              {"repairs", describe(report.read.mesh().repairs).c_str()},
              {"warnings", std::move(warnings)},
              {"notes", notes_json(report.read)},
              {"counts",
               {{"triangles", statistics.triangles},
                {"crossing", statistics.crossing_triangles},
                {"loops", statistics.section_loops},
                {"open_chains", statistics.open_chains},
                {"triangles_touched", statistics.triangles_touched},
                {"nodes_visited", statistics.nodes_visited},
                {"cap_steps", statistics.cap_steps},
                {"bytes_to_upload", statistics.bytes_to_upload}}},
              {"section_area", report.section_area}};
    if (report.status != Status::missed) {
        json["positive"] = side_json(report.positive);
        json["negative"] = side_json(report.negative);
    }
    json["time_ms"] = {{"prepare", report.prepare_ms}, {"cut", report.cut_ms}, {"phases", std::move(phases)}};
    return json;
}

std::string side_text(const char* name, const SideReport& side)
{
    std::string text = std::string(name) + ": " + facts_text(side.total()) + "\n";
    for (const Piece& piece : side.pieces) {
        text += "  " + piece.file;
        if (side.pieces.size() > 1) text += ": " + facts_text(piece.facts);
        text += "\n";
    }
    return text;
}

std::string report_text(const CutReport& report)
{
    const CutStatistics& statistics = report.statistics;
    std::string text;
    for (const std::string& note : notes_text(report.read)) text += "note: " + note + "\n";
    if (const Sentence repairs = describe(report.read.mesh().repairs); !repairs.is_empty())
        text += std::string("repaired: ") + repairs.c_str() + "\n";
    if (report.has_coarse_coordinates) text += std::string("warning: ") + kCoarseCoordinatesText + "\n";
    if (report.status == Status::missed)
        return text + "missed: the plane does not divide " + report.file + "; nothing was written\n";

    text += std::string(outcome_name(report.status)) + ": " + grouped(statistics.crossing_triangles) + " of " +
            counted(statistics.triangles, "triangle") + " crossing, " +
            counted(statistics.section_loops, "section loop") + ", section area " + rounded(report.section_area) + "\n";
    if (report.status == Status::open_section)
        text += "the mesh is open: " + counted(statistics.open_chains, "part") +
                " of the section ended at its boundary, without a cap\n";
    for (const auto& [name, side] : {std::pair{"positive", &report.positive}, {"negative", &report.negative}}) {
        text += side_text(name, *side);
        if (report.caps_exceed_section)
            text += "  its cap has area " + rounded(side->total().cap_area) + ", which is not the section's" +
                    (report.closes_with_fan ? ": the fan does not fit\n"
                                            : ": the section may wind backwards or cross itself too often\n");
    }
    text += report.backend + ": prepare " + rounded(report.prepare_ms) + " ms, cut " + rounded(report.cut_ms) + " ms";
    std::string phases;
    for (std::size_t i = 0; i < kPhaseCount; ++i)
        if (statistics.phase_ms[i] > 0.0)
            phases += (phases.empty() ? " (" : ", ") + std::string(kerf::text(static_cast<Phase>(i))) + " " +
                      rounded(statistics.phase_ms[i]);
    return text + phases + (phases.empty() ? "\n" : ")\n");
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

void run(const CutCommandOptions& options)
{
    const CutReport report = perform(options);
    if (options.json)
        print(report_json(report));
    else
        print(report_text(report));
}

}  // namespace

void add_cut_command(CLI::App& program)
{
    auto options = std::make_shared<CutCommandOptions>();
    CLI::App* command = program.add_subcommand("cut", "Cut a mesh by a plane and write both sides");
    command->add_option("FILE", options->file, "Mesh: obj, ply, stl, off, gltf or glb")->required();
    CLI::Option* point =
        command
            ->add_option_function<std::string>(
                "--point", [options](const std::string& text) { options->point = parse_point("--point", text); },
                "A point of the plane, each coordinate rounded to float as in the mesh; default: the centre of the "
                "mesh's bounds")
            ->type_name("X,Y,Z");
    CLI::Option* normal = command
                              ->add_option_function<std::string>(
                                  "--normal",
                                  [options](const std::string& text) {
                                      options->normal = parse_vector("--normal", text);
                                      if (!Plane::at(Point(0, 0, 0), Normal(*options->normal)))
                                          throw CLI::ValidationError("--normal", "'" + text + "' has no direction");
                                  },
                                  "The plane's normal, of any length; it points to the positive side")
                              ->type_name("X,Y,Z");
    command
        ->add_option_function<std::string>(
            "--plane", [options](const std::string& text) { options->plane = parse_axis_plane("--plane", text); },
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
                options->plane = parse_plane_through("--through", points);
            },
            "A plane through three points instead; they run counter-clockwise if they are seen from its positive side")
        ->type_name("X,Y,Z X,Y,Z X,Y,Z")
        ->expected(3)
        ->excludes(point)
        ->excludes(normal)
        ->excludes(plane);
    command
        ->add_option_function<std::string>(
            "--gap", [options](const std::string& text) { options->gap = parse_width("--gap", text); },
            "Width of the blade, in the mesh's unit: what lies within half of it is taken away")
        ->type_name("NUMBER");
    CLI::Option* gap = command->get_option("--gap");
    const auto only = [&](const char* name, OnlyNear::Extent extent, const char* description) {
        return command
            ->add_option_function<std::string>(
                name,
                [options, name, extent](const std::string& text) {
                    const glm::dvec3 p = parse_point(name, text);
                    options->only = OnlyNear{{p.x, p.y, p.z}, extent};
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
    command->add_flag("--no-cap", options->no_cap, "Leave the section open");
    command
        ->add_option_function<std::string>(
            "--cap-quality",
            [options](const std::string& text) {
                options->cap_quality = text == "delaunay" ? CapQuality::delaunay : CapQuality::fast;
                if (!has_cap_quality(options->cap_quality))
                    throw CLI::ValidationError("--cap-quality",
                                               "this kerf was built without CGAL, which delaunay needs");
            },
            "Triangles of the caps: fast, or delaunay, which has no needles but where the outline forces them")
        ->check(CLI::IsMember({"fast", "delaunay"}).description(""))
        ->default_str("fast");
    command->add_flag("--components", options->components, "Write the connected pieces of each side one by one");
    command->add_option("--out", options->prefix, "Beginning of the names of the files to write")
        ->type_name("PREFIX")
        ->check(CLI::Validator(
            [](const std::string& prefix) {
                const bool has_name = !std::filesystem::path(prefix).filename().empty();
                return has_name ? std::string()
                                : "'" + prefix + "' names no file; put the beginning of a name at its end";
            },
            ""))
        ->required();
    command->add_option("--format", options->format, "Format of the files: obj, ply, stl, off or glb")
        ->check(CLI::IsMember(writable_formats()).description(""))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print JSON instead of text");
    command->footer(
        "Writes PREFIX.positive.obj and PREFIX.negative.obj, with --components PREFIX.positive.0.obj and so on:\n"
        "all of them or, when something goes wrong, none. A plane that misses writes nothing.\n\n"
        "Back ends:\n" +
        list_of_backends() +
        "\nExamples:\n"
        "  kerf cut rook.obj --normal 0,1,0 --out /tmp/rook\n"
        "  kerf cut rook.obj --plane y=0.5 --out /tmp/rook\n"
        "  kerf cut rook.obj --through 0,0,0 1,0,0 0,1,1 --gap 0.1 --out /tmp/rook\n"
        "  kerf cut knot.off --point 0.1,0,0 --normal 1,0.5,0 --components --format ply --out knot --json");
    command->callback([options, backend, lookup] {
        if (!options->normal && !options->plane) throw CLI::RequiredError("--normal, --plane or --through");
        if (backend->empty() && !lookup->empty()) options->backend = backend_with_lookups();
        try {
            static_cast<void>(full_name(options->backend, options->lookup));
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError("--lookup", error.what());
        }
        run(*options);
    });
}

}  // namespace kerf::tools
