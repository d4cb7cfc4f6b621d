#pragma once

#include <kerf/drawing.h>
#include <kerf/section.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "tools/mesh_files.h"
#include "tools/text.h"

// What `kerf section` says.

namespace kerf::tools {

struct SectionReport
{
    std::string file, backend;
    bool is_stack = false;  ///< several planes were asked for
    Normal normal{0, 0, 1};
    LengthUnit unit = LengthUnit::millimetre;
    FileReport read;
    SectionStack stack;
    std::vector<std::string> written;
    double prepare_ms = 0.0, section_ms = 0.0;

    bool has_paths() const
    {
        return std::ranges::any_of(stack.all(), [](const Section& section) { return section.path_count() > 0; });
    }
};

/// `area`, `length` and `loops` at the top for one plane, in a list `sections` for several.
Json report_json(const SectionReport& report);
std::string report_text(const SectionReport& report);

/// The drawing as JSON: what report_json() says of these sections, with the points of each loop.
Json drawing_json(const SectionReport& report, std::span<const Section> sections);

}  // namespace kerf::tools
