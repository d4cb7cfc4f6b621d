#include "common/io/reading_notes.h"

#include <algorithm>

namespace kerf::core::io {

std::string describe(const ReadingNote& note)
{
    return std::to_string(note.count) + " " + note.what;
}

void ReadingNotes::add(std::string_view what, std::uint64_t count)
{
    if (count == 0) return;
    const auto find = [&](std::string_view text) {
        return std::find_if(notes_.begin(), notes_.end(), [&](const ReadingNote& note) { return note.what == text; });
    };
    auto note = find(what);
    if (note == notes_.end() && notes_.size() >= kMostKinds) {
        what = "other things passed over";
        note = find(what);
    }
    if (note == notes_.end())
        notes_.push_back({std::string(what), count});
    else
        note->count += count;
}

std::string ReadingNotes::describe() const
{
    std::string text;
    for (const ReadingNote& note : notes_) text += (text.empty() ? "" : ", ") + io::describe(note);
    return text;
}

}  // namespace kerf::core::io
