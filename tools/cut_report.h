#pragma once

#include <kerf/cut.h>
#include <kerf/io.h>

#include <string>
#include <vector>

#include "tools/fragment_facts.h"
#include "tools/text.h"

// What `kerf cut` says of a cut.

namespace kerf::tools {

/// One fragment that was written.
struct CutPiece
{
    std::string file;
    FragmentFacts facts;
};

struct SideReport
{
    std::vector<CutPiece> pieces;

    FragmentFacts total() const
    {
        FragmentFacts sum;
        for (const CutPiece& piece : pieces) sum.add(piece.facts);
        return sum;
    }
};

struct CutReport
{
    std::string file, backend;
    Plane plane = Plane::z(0.0).value();
    bool closes_with_fan = false;
    bool has_gap = false;  ///< two cuts, and their counters together
    Status status = Status::missed;
    std::string repairs;
    Json notes = Json::array();
    std::vector<std::string> note_texts;
    bool has_coarse_coordinates = false;
    CutStatistics statistics;
    double section_area = 0.0;
    bool caps_exceed_section = false;
    double prepare_ms = 0.0, cut_ms = 0.0;
    SideReport positive, negative;

    /// What a cut says of itself.
    void take(const Cut& cut)
    {
        status = cut.status;
        statistics = cut.statistics();
        section_area = cut.section_area;
        caps_exceed_section = cut.caps_exceed_section;
    }
};

/// All but the times: the same in every run.
Json cut_json(const CutReport& report);
Json times_json(const CutReport& report);
std::string cut_text(const CutReport& report);

}  // namespace kerf::tools
