#pragma once

#include "common/io/reading_notes.h"
#include "tools/text.h"

namespace kerf::tools {

/// What a reader noted, the same for every command: a list of {"what", "count"}.
inline Json notes_json(const io::ReadingNotes& notes)
{
    Json list = Json::array();
    for (const io::ReadingNote& note : notes.list()) list.push_back(Json{{"what", note.what}, {"count", note.count}});
    return list;
}

}  // namespace kerf::tools
