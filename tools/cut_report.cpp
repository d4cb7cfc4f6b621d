#include "tools/cut_report.h"

#include <string>
#include <utility>

namespace kerf::tools {

namespace {

Json side_json(const SideReport& side)
{
    Json json = facts_json(side.total());
    json["pieces"] = Json::array();
    for (const CutPiece& piece : side.pieces) {
        Json entry{{"file", piece.file}};
        entry.update(facts_json(piece.facts));
        json["pieces"].push_back(std::move(entry));
    }
    return json;
}

std::string side_text(const char* name, const SideReport& side)
{
    std::string text = std::string(name) + ": " + facts_text(side.total()) + "\n";
    for (const CutPiece& piece : side.pieces) {
        text += "  " + piece.file;
        if (side.pieces.size() > 1) text += ": " + facts_text(piece.facts);
        text += "\n";
    }
    return text;
}

}  // namespace

Json cut_json(const CutReport& report)
{
    const CutStatistics& statistics = report.statistics;
    Json warnings = Json::array();
    if (report.has_coarse_coordinates) warnings.push_back("coarse_coordinates");
    if (report.caps_exceed_section) warnings.push_back("caps_exceed_section");
    Json json{{"file", report.file},
              {"backend", report.backend},
              {"status", outcome_name(report.status)},
              {"plane", {{"normal", vector_json(to_glm(report.plane.normal()))}, {"offset", report.plane.offset()}}},
              {"repairs", report.repairs},
              {"warnings", std::move(warnings)},
              {"notes", report.notes},
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
    return json;
}

Json times_json(const CutReport& report)
{
    Json phases = Json::object();
    for (std::size_t i = 0; i < kPhaseCount; ++i) phases[text(static_cast<Phase>(i))] = report.statistics.phase_ms[i];
    phases["pivot"] = 0.0;  // the report's loop over new pivots: only benchmarks run it, but the field is published
    return {{"prepare", report.prepare_ms}, {"cut", report.cut_ms}, {"phases", std::move(phases)}};
}

std::string cut_text(const CutReport& report)
{
    const CutStatistics& statistics = report.statistics;
    std::string text;
    for (const std::string& note : report.note_texts) text += "note: " + note + "\n";
    if (!report.repairs.empty()) text += "repaired: " + report.repairs + "\n";
    if (report.has_coarse_coordinates) text += std::string("warning: ") + kCoarseCoordinatesText + "\n";
    if (report.status == Status::missed)
        return text + "missed: the plane does not divide " + report.file + "; nothing was written\n";

    const std::string crossing =
        report.has_gap
            ? counted(statistics.crossing_triangles, "crossing triangle") + " in both cuts together"
            : grouped(statistics.crossing_triangles) + " of " + counted(statistics.triangles, "triangle") + " crossing";
    text += std::string(outcome_name(report.status)) + ": " + crossing + ", " +
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

}  // namespace kerf::tools
