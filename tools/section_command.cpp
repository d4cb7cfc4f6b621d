#include <kerf/drawing.h>
#include <kerf/section.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/support/stopwatch.h"
#include "tools/commands.h"
#include "tools/flat_mesh.h"
#include "tools/heights.h"
#include "tools/input.h"
#include "tools/mesh_info.h"
#include "tools/progress_line.h"
#include "tools/registry.h"
#include "tools/section_report.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct SectionCommandOptions
{
    InputOptions input;
    glm::dvec3 normal{0, 0, 1};
    std::optional<glm::dvec3> point;
    std::optional<Plane> plane;
    std::optional<double> height;
    std::vector<double> heights;
    std::size_t count = 0;
    std::optional<Vec3d> up;
    LengthUnit unit = LengthUnit::millimetre;
    std::string out, format;
    bool each = false;
    bool json = false;
    bool must_meet = false;
    std::string backend;
    std::uint32_t threads = 0;

    bool is_stack() const { return !heights.empty() || count > 0; }
};

constexpr std::array kUnits{LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::metre, LengthUnit::inch,
                            LengthUnit::foot};

/// The least and the largest distance from the origin along a plane's normal that a box has.
std::array<double, 2> reach_along(const Plane& level, const Box& box)
{
    std::array<double, 2> reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int corner = 0; corner < 8; ++corner) {
        const double d =
            level.distance({(corner & 1) != 0 ? box.hi.x : box.lo.x, (corner & 2) != 0 ? box.hi.y : box.lo.y,
                            (corner & 4) != 0 ? box.hi.z : box.lo.z});
        reach = {std::min(reach[0], d), std::max(reach[1], d)};
    }
    return reach;
}

/// Where the planes are, as distances from the origin along the normal.
std::vector<double> heights_of(const SectionCommandOptions& options, const Plane& level, const Box& bounds)
{
    if (options.plane) return {options.plane->offset()};
    if (options.height) return {*options.height};
    if (!options.heights.empty()) return options.heights;
    const auto [lowest, highest] = reach_along(level, bounds);
    if (options.count > 0) return heights_between(lowest, highest, options.count);
    const glm::dvec3 centre = 0.5 * (glm::dvec3(to_glm(bounds.lo)) + glm::dvec3(to_glm(bounds.hi)));
    const glm::dvec3 through = options.point.value_or(centre);
    return {level.distance({through.x, through.y, through.z})};
}

/// An object of the back end that was asked for, otherwise of the one that is quicker for these planes.
Object prepared(Mesh mesh, const SectionCommandOptions& options, const Plane& level, std::span<const double> heights)
{
    PrepareOptions prepare_options;
    prepare_options.back_end_name = options.backend.empty() ? nullptr : options.backend.c_str();
    if (options.backend.empty()) prepare_options.back_end = quicker_for_sections(mesh, level.normal(), heights);
    prepare_options.threads = options.threads;
    Result<Object> object = prepare(std::move(mesh), prepare_options);
    if (!object) throw std::runtime_error(options.input.file + ": " + object.reason());
    return *std::move(object);
}

SectionStack find(const Object& object, const Plane& level, const std::vector<double>& heights,
                  const SectionCommandOptions& options)
{
    ProgressLine line("sections");
    StackOptions stack_options;
    stack_options.section.up = options.up;
    stack_options.threads = options.threads;
    stack_options.user = &line;
    stack_options.progress = [](void* user, double share) {
        static_cast<ProgressLine*>(user)->show(share);
        return true;
    };
    SectionStack stack = sections(object, level.normal(), heights, stack_options);
    if (!ok(stack.status())) throw std::runtime_error(options.input.file + ": " + stack.reason());
    return stack;
}

const std::vector<std::string> kFormats{"svg", "dxf", "obj", "json"};

/// @throws FileError  the extension is none of a drawing
std::string format_of(const SectionCommandOptions& options)
{
    if (!options.format.empty()) return options.format;
    const std::string extension = std::filesystem::path(options.out).extension().string();
    if (extension.empty()) return "svg";
    if (std::ranges::find(kFormats, extension.substr(1)) == kFormats.end())
        throw FileError(options.out +
                        ": the extension is not one of svg, dxf, obj, json; say --format, or another name");
    return extension.substr(1);
}

/// A direction along the normal points nowhere in the plane.
void check_up(const SectionCommandOptions& options)
{
    if (!options.up) return;
    const Vec3d n = options.plane ? Vec3d(options.plane->normal()) : Vec3d(options.normal);
    const glm::dvec3 across =
        glm::cross(glm::dvec3(n.x, n.y, n.z), glm::dvec3(options.up->x, options.up->y, options.up->z));
    if (across == glm::dvec3(0.0))
        throw CLI::ValidationError("--up", "it points along the normal, and nowhere in the plane");
}

/// PREFIX.0001.svg: the number of a section in the name of its file.
std::string name_of_layer(const std::string& out, std::size_t number)
{
    std::string digits = std::to_string(number);
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    const std::filesystem::path path(out);
    return (path.parent_path() / (path.stem().string() + "." + digits + path.extension().string())).string();
}

/// Writes what was asked for; the names of the files.
std::vector<std::string> write(const SectionCommandOptions& options, const SectionReport& report)
{
    if (options.out.empty()) return {};
    const std::span<const Section> all = report.stack.all();
    const DrawingOptions drawing{options.unit};
    const std::string format = format_of(options);
    const auto text_of = [&](std::span<const Section> sections) {
        if (format == "json") return drawing_json(report, sections).dump(2) + "\n";
        const Result<FileBytes> bytes = drawing_bytes(sections, format.c_str(), drawing);
        if (!bytes) throw FileError(options.out + ": " + bytes.reason());
        return std::string(reinterpret_cast<const char*>(bytes->bytes().data()), bytes->bytes().size());
    };
    if (options.out == "-") {
        print(text_of(all));
        return {};
    }
    MeshFileSet files(report.read);
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, std::span<const Section> sections) {
        const std::string text = text_of(sections);
        check(files.add(name.c_str(), std::as_bytes(std::span(text))));
        names.push_back(name);
    };
    if (!options.each) add(options.out, all);
    for (std::size_t i = 0; options.each && i < all.size(); ++i)
        if (all[i].path_count() > 0) add(name_of_layer(options.out, i + 1), all.subspan(i, 1));
    check(files.commit());
    return names;
}

void run(const SectionCommandOptions& options)
{
    LoadedFile loaded = load_input(options.input);
    const std::optional<Plane> level =
        Plane::at(Point(0, 0, 0), options.plane ? options.plane->normal() : Normal(options.normal));
    const std::vector<double> heights = heights_of(options, *level, loaded.mesh.bounds());
    SectionReport report;
    report.file = options.input.file;
    report.is_stack = options.is_stack();
    report.normal = level->normal();
    report.unit = options.unit;
    core::Stopwatch watch;
    const Object object = prepared(std::move(loaded.mesh), options, *level, heights);
    report.prepare_ms = watch.lap();
    report.backend = object.back_end_name();
    report.stack = find(object, *level, heights, options);
    report.section_ms = watch.lap();
    report.read = std::move(loaded.report);
    if (report.has_paths()) report.written = write(options, report);
    if (options.json)
        print(report_json(report));
    else if (options.out != "-")
        print(report_text(report));
    if (options.must_meet && !report.has_paths()) throw NothingToCut(report.file + ": no plane meets it");
}

}  // namespace

void add_section_command(CLI::App& program)
{
    auto options = std::make_shared<SectionCommandOptions>();
    CLI::App* command =
        program.add_subcommand("section", "Say and draw what planes meet of a mesh, without cutting it");
    add_input_options(*command, options->input);
    CLI::Option* normal = command
                              ->add_option_function<std::string>(
                                  "--normal",
                                  [options](const std::string& text) {
                                      options->normal = parse_vector("--normal", text);
                                      if (!Plane::at(Point(0, 0, 0), Normal(options->normal)))
                                          throw CLI::ValidationError("--normal", "'" + text + "' has no direction");
                                  },
                                  "Where the planes' normal points to; drawings are seen from there. Default: 0,0,1")
                              ->type_name("X,Y,Z");
    CLI::Option* point =
        command
            ->add_option_function<std::string>(
                "--point", [options](const std::string& text) { options->point = parse_point("--point", text); },
                "A point of the plane; default: the centre of the mesh's bounds")
            ->type_name("X,Y,Z");
    CLI::Option* height =
        command
            ->add_option_function<std::string>(
                "--height", [options](const std::string& text) { options->height = parse_height("--height", text); },
                "Distance of the plane from the origin, along the normal, instead")
            ->type_name("NUMBER");
    CLI::Option* heights =
        command
            ->add_option_function<std::string>(
                "--heights",
                [options](const std::string& text) { options->heights = parse_heights("--heights", text); },
                "Several planes: distances from the origin along the normal, such as 0:1:0.02")
            ->type_name("FROM:TO:STEP");
    CLI::Option* count = command->add_option("--count", options->count, "So many planes through the mesh, evenly")
                             ->check(CLI::Range(std::size_t(1), std::size_t(1'000'000)));
    CLI::Option* plane =
        command
            ->add_option_function<std::string>(
                "--plane", [options](const std::string& text) { options->plane = parse_axis_plane("--plane", text); },
                "A plane across an axis, such as x=0.5; its normal points along the axis, with --plane=-x=0.5 against "
                "it")
            ->type_name("AXIS=NUMBER");
    const std::array<CLI::Option*, 5> places{point, height, heights, count, plane};
    for (CLI::Option* one : places)
        for (CLI::Option* other : places)
            if (one != other) one->excludes(other);
    plane->excludes(normal);
    command
        ->add_option_function<std::string>(
            "--up",
            [options](const std::string& text) {
                const glm::dvec3 up = parse_vector("--up", text);
                if (up == glm::dvec3(0.0)) throw CLI::ValidationError("--up", "'" + text + "' has no direction");
                options->up = Vec3d(up.x, up.y, up.z);
            },
            "What points upwards in drawings; default: z, and y in planes that are nearly level")
        ->type_name("X,Y,Z");
    std::vector<std::string> units;
    for (const LengthUnit unit : kUnits) units.emplace_back(text(unit));
    command
        ->add_option_function<std::string>(
            "--unit",
            [options](const std::string& name) {
                for (const LengthUnit unit : kUnits)
                    if (name == text(unit)) options->unit = unit;
            },
            "Unit of the mesh: mm, cm, m, in or ft. SVG and DXF are in millimetres")
        ->check(CLI::IsMember(units).description(""))
        ->default_str("mm");
    CLI::Option* out = command->add_option("-o,--out", options->out, "File to write; - is the standard output");
    command->add_option("--format", options->format, "Format of it: svg, dxf, obj or json; default: by its extension")
        ->check(CLI::IsMember(kFormats).description(""));
    command
        ->add_flag("--each", options->each, "A file for each plane: OUT.0001.svg and so on, where there is something")
        ->needs(out);
    command->add_flag("--require-cut", options->must_meet, "Exit status 3 if no plane meets the mesh");
    CLI::Option* json = command->add_flag(
        "--json", options->json, "Print JSON instead of text, without the points: a file of --format json has them");
    command
        ->add_option("--backend", options->backend,
                     "Which way to find sections; default: linear where preparing would take longer than it saves")
        ->check(CLI::IsMember(backend_choices()).description(""));
    command->add_option("--threads", options->threads, "How many may work; 0: as many as the processor has")
        ->capture_default_str();
    command->footer(
        "Writes nothing if no plane meets the mesh. Outer loops run counter-clockwise, holes clockwise.\n\n"
        "Examples:\n"
        "  kerf section rook.obj --normal 0,1,0 -o rook.svg\n"
        "  kerf section rook.obj --plane y=0.5 --json\n"
        "  kerf section brain.ply --count 100 -o brain.dxf\n"
        "  kerf section part.stl --heights 0:20:0.2 --each -o layers/part.svg");
    command->callback([options, json] {
        check_input(options->input);
        if (options->out == "-" && (options->each || !json->empty()))
            throw CLI::ValidationError("--out", "the standard output takes one drawing, and nothing besides");
        if (!options->backend.empty()) options->backend = full_name(options->backend);
        check_up(*options);
        run(*options);
    });
}

}  // namespace kerf::tools
