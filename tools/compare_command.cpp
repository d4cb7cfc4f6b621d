#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line/whole_number.h"
#include "common/support/median.h"
#include "tools/commands.h"
#include "tools/comparison.h"
#include "tools/mesh_files.h"
#include "tools/registry.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

struct CompareCommandOptions
{
    std::vector<std::string> files;
    ComparisonOptions comparison;
    std::optional<std::uint64_t> only;
    std::string first = "baseline", lookup;
    bool random_only = false;
    bool quiet = false;
    bool json = false;
    bool caps = false;
};

/// What the rows of a file, or of all files, say together.
struct Tally
{
    std::uint64_t rows = 0, cut = 0, missed = 0, surfaces_differ = 0, pieces_differ = 0, failed = 0;
    std::uint64_t fans_wrong = 0, caps_wrong = 0, crossed_sections = 0, unjudged_sections = 0;
    double worst_fan = 0.0;  ///< excess relative to the section; sections without area don't count
    double worst_cap = 0.0;  ///< where the section does not intersect itself
    std::uint64_t baseline_open_edges = 0, halfedge_open_edges = 0;
    std::uint64_t baseline_degenerate = 0, halfedge_degenerate = 0;
    double baseline_volume_error = 0.0, halfedge_volume_error = 0.0;
    std::vector<double> baseline_ms, halfedge_ms;

    void add(const ComparisonRow& row);
    void add(const Tally& other);
};

double relative_to_section(double excess, const ComparisonRow& row)
{
    return row.section_is_speck ? 0.0 : excess / row.covered_area;
}

/// The one that is farther from 0.
double worse(double a, double b)
{
    return std::abs(b) > std::abs(a) ? b : a;
}

void Tally::add(const ComparisonRow& row)
{
    ++rows;
    if (!row.failures.empty()) ++failed;
    if (!row.was_cut()) {
        ++missed;
        return;
    }
    ++cut;
    if (!row.surfaces_equal()) ++surfaces_differ;
    if (!row.pieces_equal) ++pieces_differ;
    if (!row.fan_fits && row.section_is_judged) {
        ++fans_wrong;
        worst_fan = worse(worst_fan, relative_to_section(row.baseline.cap_excess, row));
    }
    if (!row.section_is_judged)
        ++unjudged_sections;
    else if (row.section_intersects_itself && !row.cap_fits)
        ++crossed_sections;
    else {
        if (!row.cap_fits) ++caps_wrong;
        if (row.loops > 0) worst_cap = worse(worst_cap, row.halfedge.cap_excess / row.judged_area);
    }
    baseline_open_edges += row.baseline.open_edges;
    halfedge_open_edges += row.halfedge.open_edges;
    baseline_degenerate += row.baseline.degenerate_triangles;
    halfedge_degenerate += row.halfedge.degenerate_triangles;
    baseline_volume_error = std::max(baseline_volume_error, row.baseline.volume_error);
    halfedge_volume_error = std::max(halfedge_volume_error, row.halfedge.volume_error);
    baseline_ms.push_back(row.baseline.ms);
    halfedge_ms.push_back(row.halfedge.ms);
}

void Tally::add(const Tally& other)
{
    rows += other.rows;
    cut += other.cut;
    missed += other.missed;
    surfaces_differ += other.surfaces_differ;
    pieces_differ += other.pieces_differ;
    failed += other.failed;
    fans_wrong += other.fans_wrong;
    caps_wrong += other.caps_wrong;
    crossed_sections += other.crossed_sections;
    unjudged_sections += other.unjudged_sections;
    worst_fan = worse(worst_fan, other.worst_fan);
    worst_cap = worse(worst_cap, other.worst_cap);
    baseline_open_edges += other.baseline_open_edges;
    halfedge_open_edges += other.halfedge_open_edges;
    baseline_degenerate += other.baseline_degenerate;
    halfedge_degenerate += other.halfedge_degenerate;
    baseline_volume_error = std::max(baseline_volume_error, other.baseline_volume_error);
    halfedge_volume_error = std::max(halfedge_volume_error, other.halfedge_volume_error);
    baseline_ms.insert(baseline_ms.end(), other.baseline_ms.begin(), other.baseline_ms.end());
    halfedge_ms.insert(halfedge_ms.end(), other.halfedge_ms.begin(), other.halfedge_ms.end());
}

template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments)
{
    char text[256];
    std::snprintf(text, sizeof text, format, arguments...);
    return text;
}

/// "right", or by how much of the section the cap covers too much: "+12.3 %".
std::string cap_text(bool fits, double excess, const ComparisonRow& row)
{
    if (row.loops == 0) return "-";
    if (fits) return "right";
    if (!row.section_is_judged) return "not judged";
    if (row.section_is_speck) return "no area";
    return formatted("%+.3g %%", 100.0 * relative_to_section(excess, row));
}

std::string pair_text(std::uint64_t a, std::uint64_t b)
{
    return std::to_string(a) + "/" + std::to_string(b);
}

std::string table_head()
{
    return formatted("%-11s %-16s %8s %5s %-7s %12s %10s %10s %5s %5s %8s %10s %10s\n", "plane", "kind", "crossing",
                     "loops", "surface", "section", "fan", "cap", "open", "equal", "volume", "baseline", "halfedge") +
           formatted("%-11s %-16s %8s %5s %-7s %12s %10s %10s %5s %5s %8s %10s %10s\n", "", "", "", "", "", "area",
                     "area", "area", "edges", "corn.", "error", "ms", "ms");
}

std::string row_text(const ComparisonRow& row)
{
    const std::string name = std::to_string(row.number) + row.piece;
    std::string text = formatted("%-11s %-16s ", name.c_str(), row.plane.kind.c_str());
    if (row.was_cut()) {
        const std::string loops =
            std::to_string(row.loops) + (row.open_chains > 0 ? "+" + std::to_string(row.open_chains) : "");
        const std::string fan = cap_text(row.fan_fits, row.baseline.cap_excess, row);
        const std::string cap = cap_text(row.cap_fits, row.halfedge.cap_excess, row);
        const std::string open = pair_text(row.baseline.open_edges, row.halfedge.open_edges);
        const std::string equal = pair_text(row.baseline.degenerate_triangles, row.halfedge.degenerate_triangles);
        text += formatted(
            "%8s %5s %-7s %12s %10s %10s %5s %5s %8.1e %10.4g %10.4g", std::to_string(row.halfedge.crossing).c_str(),
            loops.c_str(), row.surfaces_equal() ? "equal" : "DIFFERS", rounded(row.section_area).c_str(), fan.c_str(),
            cap.c_str(), open.c_str(), equal.c_str(), std::max(row.baseline.volume_error, row.halfedge.volume_error),
            row.baseline.ms, row.halfedge.ms);
        if (!row.pieces_equal) text += "  PIECES DIFFER";
        if (row.section_intersects_itself) text += "  the section intersects itself";
        if (!row.section_is_judged) text += "  the section crosses itself too often to be judged";
    } else {
        text += outcome_name(row.halfedge.status);
    }
    if (row.baseline.status != row.halfedge.status)
        text += "  baseline: " + std::string(outcome_name(row.baseline.status));
    if (!row.earlier_caps_fit) text += "  (after a wrong cap)";
    text += "\n";
    if (!row.failures.empty()) {
        const Normal normal = row.plane.plane.normal();
        text += formatted("  FAILS (normal %.17g,%.17g,%.17g offset %.17g):", normal.x, normal.y, normal.z,
                          row.plane.plane.offset());
        for (std::size_t i = 0; i < row.failures.size(); ++i) text += (i > 0 ? "; " : " ") + row.failures[i];
        text += "\n";
    }
    return text;
}

/// @param first  what the caps of the back end beside halfedge are called
std::string tally_text(const std::string& name, const std::string& first, const Tally& tally)
{
    std::string text =
        name + ": " + counted(tally.cut, "cut") + ", " + grouped(tally.missed) + " missed; surfaces " +
        (tally.surfaces_differ == 0 ? "equal bit for bit" : "differ in " + grouped(tally.surfaces_differ));
    if (tally.pieces_differ > 0) text += "; pieces differ in " + grouped(tally.pieces_differ);
    text += "; " + first + " wrong in " + grouped(tally.fans_wrong);
    if (tally.fans_wrong > 0) text += formatted(" (at worst by %+.3g %%)", 100.0 * tally.worst_fan);
    text += ", half-edge cap in " + grouped(tally.caps_wrong) + formatted(" (worst %+.1e)", tally.worst_cap);
    if (tally.crossed_sections > 0)
        text += ", not judged in " + grouped(tally.crossed_sections) + " whose section intersects itself";
    if (tally.unjudged_sections > 0)
        text +=
            ", not judged in " + grouped(tally.unjudged_sections) + " whose section crosses itself too often to tell";
    text += "; open edges " + pair_text(tally.baseline_open_edges, tally.halfedge_open_edges) + "; equal corners " +
            pair_text(tally.baseline_degenerate, tally.halfedge_degenerate);
    text += formatted("; volume error %.1e/%.1e", tally.baseline_volume_error, tally.halfedge_volume_error);
    text += formatted("; median ms %.4g/%.4g", core::median(tally.baseline_ms), core::median(tally.halfedge_ms));
    if (tally.failed > 0) return text + "; " + counted(tally.failed, "row") + " FAILED\n";
    if (tally.rows == 0) return text + "; nothing was compared\n";
    return text + (tally.crossed_sections + tally.unjudged_sections > 0 ? "; agree where judged\n" : "; agree\n");
}

Json back_end_json(const BackEndRow& facts)
{
    return {{"status", outcome_name(facts.status)},
            {"crossing", facts.crossing},
            {"triangles", {{"positive", facts.triangles[0]}, {"negative", facts.triangles[1]}}},
            {"cap_area", {{"positive", facts.cap_area[0]}, {"negative", facts.cap_area[1]}}},
            {"cap_excess", facts.cap_excess},
            {"caps_exceed_section", facts.says_caps_exceed},
            {"open_edges", facts.open_edges},
            {"equal_corners", facts.degenerate_triangles},
            {"volume_error", facts.volume_error},
            {"overhang", facts.overhang},
            {"cap_triangles", facts.cap.triangles.size()},
            {"cap_least_angle", facts.least_angle},
            {"cap_overlap", std::isnan(facts.overlap) ? Json() : Json(facts.overlap)},
            {"cut_ms", facts.ms}};
}

Json points_json(const std::vector<glm::dvec2>& points)
{
    Json list = Json::array();
    for (const glm::dvec2& p : points) list.push_back({p.x, p.y});
    return list;
}

/// The outline and both caps in the coordinates of the plane.
Json caps_json(const ComparisonRow& row)
{
    const auto cap_json = [](const FlatCap& cap) {
        return Json{{"points", points_json(cap.points)}, {"triangles", cap.triangles}};
    };
    Json loops = Json::array();
    for (const auto& loop : row.outline) loops.push_back(points_json(loop));
    return {{"loops", std::move(loops)},
            {"baseline", cap_json(row.baseline.cap)},
            {"halfedge", cap_json(row.halfedge.cap)}};
}

Json row_json(const ComparisonRow& row)
{
    const auto difference_json = [](const SurfaceDifference& difference) {
        return Json{{"only_baseline", difference.only_first}, {"only_halfedge", difference.only_second}};
    };
    return {
        {"number", row.number},
        {"piece", row.piece},
        {"kind", row.plane.kind},
        {"plane", {{"normal", vector_json(to_glm(row.plane.plane.normal()))}, {"offset", row.plane.plane.offset()}}},
        {"status", outcome_name(row.halfedge.status)},
        {"crossing", row.halfedge.crossing},
        {"loops", row.loops},
        {"open_chains", row.open_chains},
        {"surfaces_equal", row.surfaces_equal()},
        {"pieces_equal", row.pieces_equal},
        {"positive", difference_json(row.surface[0])},
        {"negative", difference_json(row.surface[1])},
        {"section_area", row.section_area},
        {"section_intersects_itself", row.section_is_judged ? Json(row.section_intersects_itself) : Json()},
        {"covered_area", row.covered_area},
        {"earlier_caps_fit", row.earlier_caps_fit},
        {"fan_fits", row.fan_fits},
        {"cap_fits", row.cap_fits},
        {"baseline", back_end_json(row.baseline)},
        {"halfedge", back_end_json(row.halfedge)},
        {"failures", row.failures}};
}

Json tally_json(const Tally& tally)
{
    return {{"rows", tally.rows},
            {"cut", tally.cut},
            {"missed", tally.missed},
            {"failed", tally.failed},
            {"surfaces_differ", tally.surfaces_differ},
            {"pieces_differ", tally.pieces_differ},
            {"fans_wrong", tally.fans_wrong},
            {"worst_fan", tally.worst_fan},
            {"caps_wrong", tally.caps_wrong},
            {"worst_cap", tally.worst_cap},
            {"sections_that_intersect_themselves", tally.crossed_sections},
            {"sections_not_judged", tally.unjudged_sections},
            {"open_edges", {{"baseline", tally.baseline_open_edges}, {"halfedge", tally.halfedge_open_edges}}},
            {"equal_corners", {{"baseline", tally.baseline_degenerate}, {"halfedge", tally.halfedge_degenerate}}},
            {"volume_error", {{"baseline", tally.baseline_volume_error}, {"halfedge", tally.halfedge_volume_error}}},
            {"median_cut_ms",
             {{"baseline", core::median(tally.baseline_ms)}, {"halfedge", core::median(tally.halfedge_ms)}}}};
}

void run(const CompareCommandOptions& options)
{
    const std::string baseline = full_name(options.first, options.lookup), halfedge = full_name("halfedge");
    if (halfedge.empty()) throw std::runtime_error("this kerf was built without the half-edge back end");
    const std::string first_family = family_of(options.first);
    const std::string first_caps = first_family == "baseline" ? "fan" : first_family + " cap";
    ComparisonOptions comparison = options.comparison;
    comparison.caps_alike = first_family != "baseline";
    comparison.mix = options.random_only ? PlaneMix::random : PlaneMix::nasty;
    if (options.only) {
        comparison.first_plane = *options.only;
        comparison.planes = 1;
    }

    Tally total;
    std::size_t bad_meshes = 0, unusable_files = 0;
    Json files = Json::array();
    for (const std::string& file : options.files) {
        Tally tally;
        Json rows = Json::array();
        ComparedMesh mesh;
        std::string error;
        try {
            const LoadedFile loaded = load(file);
            comparison.was_closed = loaded.facts().unbalanced_edges == 0;
            if (!options.json && !options.quiet) print(file + "\n" + table_head());
            mesh = compare_mesh(loaded.mesh, baseline, halfedge, comparison, [&](const ComparisonRow& row) {
                tally.add(row);
                if (options.json) {
                    rows.push_back(row_json(row));
                    if (options.caps) rows.back()["caps"] = caps_json(row);
                } else if (!options.quiet || !row.failures.empty())
                    print(row_text(row));
            });
        } catch (const OutputError&) {
            throw;
        } catch (const FileError& reason) {
            error = reason.what();
        } catch (const std::runtime_error& reason) {
            error = file + ": " + reason.what();
        } catch (const std::bad_alloc&) {
            error = file + ": there is not enough memory to compare it";
        }
        total.add(tally);
        if (!mesh.failures.empty()) ++bad_meshes;
        if (!error.empty()) {
            // One of thousands is a row. One alone is the end, with nothing on standard output but rows.
            if (options.files.size() == 1) throw std::runtime_error(error);
            ++unusable_files;
            if (options.json)
                files.push_back(Json{{"file", file}, {"error", error}, {"rows", std::move(rows)}});
            else
                print("NOT COMPARED: " + error + "\n" + (options.quiet ? "" : "\n"));
            continue;
        }
        const std::string name = std::filesystem::path(file).filename().string();
        if (options.json) {
            files.push_back(
                Json{{"file", file},
                     {"triangles", mesh.triangles},
                     {"closed", mesh.closed},
                     {"prepare_ms", {{"baseline", mesh.baseline_prepare_ms}, {"halfedge", mesh.halfedge_prepare_ms}}},
                     {"failures", mesh.failures},
                     {"rows", std::move(rows)},
                     {"summary", tally_json(tally)}});
            continue;
        }
        for (const std::string& failure : mesh.failures) print(name + ": FAILS: " + failure + "\n");
        print(tally_text(name + ", " + counted(mesh.triangles, "triangle") + (mesh.closed ? ", closed" : ", open"),
                         first_caps, tally) +
              (options.quiet ? "" : "\n"));
    }
    if (options.json)
        print(Json{{"baseline", baseline},
                   {"halfedge", halfedge},
                   {"seed", comparison.seed},
                   {"unusable_files", unusable_files},
                   {"files", std::move(files)},
                   {"total", tally_json(total)}});
    else if (options.files.size() > 1)
        print(tally_text("all " + counted(options.files.size(), "file") +
                             (unusable_files > 0 ? ", " + grouped(unusable_files) + " of them NOT COMPARED" : ""),
                         first_caps, total));
    std::string failed;
    if (total.failed > 0 || bad_meshes > 0)
        failed = "the comparison failed in " + grouped(total.failed) + " of " + counted(total.rows, "row") +
                 (bad_meshes > 0 ? " and when preparing " + counted(bad_meshes, "mesh") : "");
    if (unusable_files > 0)
        failed += (failed.empty() ? "" : "; ") + grouped(unusable_files) + " of " +
                  counted(options.files.size(), "file") + " could not be compared";
    if (!failed.empty()) throw std::runtime_error(failed);
}

std::vector<std::string> choices_beside_halfedge()
{
    std::vector<std::string> choices = backend_choices();
    std::erase(choices, "halfedge");
    return choices;
}

}  // namespace

void add_compare_command(CLI::App& program)
{
    auto options = std::make_shared<CompareCommandOptions>();
    CLI::App* command = program.add_subcommand("compare", "Cut meshes with both back ends and compare what comes out");
    command->add_option("FILE", options->files, "Meshes: obj, ply, stl, off, gltf or glb")->required();
    command->add_option("--planes", options->comparison.planes, "How many planes cut each mesh")
        ->transform(command_line::whole_number(1, 1'000'000))
        ->capture_default_str();
    command->add_option("--seed", options->comparison.seed, "Another seed gives other planes")
        ->transform(command_line::whole_number())
        ->capture_default_str();
    command
        ->add_option("--depth", options->comparison.depth,
                     "Cuts in a row: 2 cuts the two pieces as well, 3 their pieces, ...")
        ->transform(command_line::whole_number(1, 16))
        ->capture_default_str();
    command
        ->add_option(
            "--with", options->first,
            "The back end beside halfedge: baseline, or baseline/LOOKUP, or linear or halfedge/cgal, whose caps must "
            "have the same areas. Rows and fields call it baseline")
        ->check(CLI::IsMember(choices_beside_halfedge()).description(""))
        ->capture_default_str();
    command->add_option("--lookup", options->lookup, "How the baseline looks up vertices: see kerf cut --help");
    command->add_flag("--random-only", options->random_only,
                      "Only random planes through the middle, none through vertices, along edges or in faces");
    command->add_option("--only", options->only, "Cut by this one of the planes, as the first column numbers them")
        ->transform(command_line::whole_number())
        ->type_name("NUMBER");
    command->add_flag("--quiet", options->quiet, "Leave out the rows of cuts that are right");
    CLI::Option* json = command->add_flag("--json", options->json, "Print JSON instead of text");
    command
        ->add_flag("--caps", options->caps, "With --json: the triangles of both caps, in the coordinates of the plane")
        ->needs(json);
    command->footer(
        "One row a cut. surface: whether the surface triangles of both sides are equal bit for bit, attributes\n"
        "included. fan and cap: by how much the caps of baseline and halfedge miss the section's area. Open edges and\n"
        "triangles with two equal corners: baseline/halfedge. volume error: relative to the whole mesh. The name of a\n"
        "piece has a + or - for each cut before; wrong caps change the shape that later planes meet. "
        "Exit status 1 when something\n"
        "is not as it must be. Of several files one that cannot be used is a row and exit status 1 at the end; the "
        "others "
        "are compared.\n\n"
        "Examples:\n"
        "  kerf compare rook.obj\n"
        "  kerf compare *.obj --planes 200 --seed 3 --quiet\n"
        "  kerf compare sponge.glb --depth 5 --only 17");
    command->callback([options] {
        try {
            static_cast<void>(full_name(options->first, options->lookup));
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError("--lookup", error.what());
        }
        run(*options);
    });
}

}  // namespace kerf::tools
