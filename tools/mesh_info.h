#pragma once

#include "common/io/reading_notes.h"
#include "common/repair/repair.h"
#include "tools/text.h"

// What several commands say of a mesh file, in the same fields.

namespace kerf::tools {

/// What a reader noted: a list of {"what", "count"}.
inline Json notes_json(const io::ReadingNotes& notes)
{
    Json list = Json::array();
    for (const io::ReadingNote& note : notes.list()) list.push_back(Json{{"what", note.what}, {"count", note.count}});
    return list;
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
            {"text", repairs.describe()}};
}

}  // namespace kerf::tools
