#pragma once

#include <string>
#include <vector>

#include "tools/mesh_files.h"
#include "tools/text.h"

// What several commands say of a mesh file, in the same fields.

namespace kerf::tools {

/// What a reader noted: a list of {"what", "count"}.
inline Json notes_json(const FileReport& report)
{
    Json list = Json::array();
    for (std::size_t i = 0; i < report.note_count(); ++i)
        list.push_back(Json{{"what", report.note(i).what}, {"count", report.note(i).count}});
    return list;
}

/// "3 normals that are not finite numbers made anew", one for each kind.
inline std::vector<std::string> notes_text(const FileReport& report)
{
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < report.note_count(); ++i)
        texts.push_back(std::to_string(report.note(i).count) + " " + report.note(i).what);
    return texts;
}

/// How often each kind of repair was made, and all of it as text.
inline Json repairs_json(const Repairs& repairs)
{
    return {{"degenerate_triangles", repairs.degenerate_triangles},
            {"duplicate_triangles", repairs.duplicate_triangles},
            {"coinciding_triangles", repairs.coinciding_triangles},
            {"nonmanifold_edges", repairs.nonmanifold_edges},
            {"nonmanifold_points", repairs.nonmanifold_points},
            {"flipped_triangles", repairs.flipped_triangles},
            {"unorientable_edges", repairs.unorientable_edges},
            {"replaced_attributes", repairs.replaced_attributes},
            {"text", describe(repairs).c_str()}};
}

}  // namespace kerf::tools
