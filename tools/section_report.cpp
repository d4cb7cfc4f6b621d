#include "tools/section_report.h"

#include <kerf/cut.h>

#include "tools/mesh_info.h"

namespace kerf::tools {

namespace {

Json numbers(const Vec3d& v)
{
    return {v.x, v.y, v.z};
}

Json path_json(const Section& section, std::size_t number, bool with_points)
{
    const SectionPath path = section.path(number);
    Json json{{"closed", path.is_closed}, {"area", path.area},
              {"length", path.length},    {"parent", path.parent == kNone ? Json() : Json(path.parent)},
              {"solid", path.solid},      {"point_count", path.points.size()}};
    if (!with_points) return json;
    Json points = Json::array(), places = Json::array();
    for (const Vec3f& p : path.points) {
        const Vec2d place = section.frame.to_plane(p);
        points.push_back({p.x, p.y, p.z});
        places.push_back({place.x, place.y});
    }
    json["points"] = std::move(points);
    json["places"] = std::move(places);
    return json;
}

/// What a section is, from `status` to `loops`.
Json section_json(const Section& section, bool with_points)
{
    Json loops = Json::array();
    for (std::size_t i = 0; i < section.path_count(); ++i) loops.push_back(path_json(section, i, with_points));
    const SectionFrame& frame = section.frame;
    return {{"height", section.frame.height},
            {"status", section.status == Status::done ? "done" : outcome_name(section.status)},
            {"area", section.area},
            {"length", section.length},
            {"centroid", section.path_count() > 0 ? numbers(section.centroid) : Json()},
            {"frame", {{"origin", numbers(frame.origin)}, {"x", numbers(frame.x)}, {"y", numbers(frame.y)}}},
            {"crossing", section.statistics().crossing_triangles},
            {"loops", std::move(loops)}};
}

/// Of one section its members at the top; otherwise a list.
void add_sections(Json& json, bool is_stack, std::span<const Section> sections, bool with_points)
{
    if (!is_stack) {
        json.update(section_json(sections.front(), with_points));
        return;
    }
    json["sections"] = Json::array();
    for (const Section& section : sections) json["sections"].push_back(section_json(section, with_points));
}

std::size_t loops_of(const Section& section)
{
    return section.statistics().section_loops;
}

std::string section_text(const Section& section)
{
    std::string text = counted(loops_of(section), "loop");
    if (const std::uint64_t chains = section.statistics().open_chains; chains > 0)
        text += ", " + counted(chains, "chain") + " that end at holes of the mesh";
    return text + ", area " + rounded(section.area) + ", length " + rounded(section.length);
}

}  // namespace

Json report_json(const SectionReport& report)
{
    Json json{{"file", report.file},
              {"backend", report.backend},
              {"normal", numbers(report.normal)},
              {"unit", text(report.unit)},
              {"repairs", describe(report.read.mesh().repairs).c_str()},
              {"notes", notes_json(report.read)}};
    add_sections(json, report.is_stack, report.stack.all(), false);
    json["files"] = report.written;
    json["time_ms"] = {{"prepare", report.prepare_ms}, {"section", report.section_ms}};
    return json;
}

Json drawing_json(const SectionReport& report, std::span<const Section> sections)
{
    Json json{{"file", report.file}, {"normal", numbers(report.normal)}, {"unit", text(report.unit)}};
    add_sections(json, sections.size() != 1, sections, true);
    return json;
}

std::string report_text(const SectionReport& report)
{
    std::string said;
    for (const std::string& note : notes_text(report.read)) said += "note: " + note + "\n";
    if (const Sentence repairs = describe(report.read.mesh().repairs); !repairs.is_empty())
        said += std::string("repaired: ") + repairs.c_str() + "\n";
    const std::span<const Section> all = report.stack.all();
    if (!report.has_paths())
        return said + "missed: " + (report.is_stack ? "no plane meets " : "the plane does not meet ") + report.file +
               "; nothing was written\n";
    if (!report.is_stack) {
        said += "section: " + section_text(all.front()) + "\n";
    } else {
        std::size_t met = 0;
        for (const Section& section : all) {
            met += section.path_count() > 0 ? 1 : 0;
            said += "at " + rounded(section.frame.height) + ": " +
                    (section.path_count() > 0 ? section_text(section) : "nothing") + "\n";
        }
        said += counted(met, "section") + " of " + counted(all.size(), "plane") + "\n";
    }
    constexpr std::size_t kMostNames = 10;
    for (std::size_t i = 0; i < std::min(report.written.size(), kMostNames); ++i)
        said += "  " + report.written[i] + "\n";
    if (report.written.size() > kMostNames) said += "  and " + grouped(report.written.size() - kMostNames) + " more\n";
    return said + report.backend + ": prepare " + rounded(report.prepare_ms) + " ms, " +
           (report.is_stack ? "sections " : "section ") + rounded(report.section_ms) + " ms\n";
}

}  // namespace kerf::tools
