#pragma once

#include <string>
#include <string_view>

#include "common/io/reading_notes.h"

namespace kerf::core::io {

/// The text of a file in UTF-8: converted, and noted, if the file is UTF-16, which some shells make of redirected
/// output; otherwise a view of the bytes. Without a byte order mark UTF-16 is told by the first two characters, which
/// are ASCII in every format. Time and memory O(size).
class PlainText
{
public:
    PlainText(std::string_view bytes, ReadingNotes& notes);
    PlainText(const PlainText&) = delete;
    PlainText& operator=(const PlainText&) = delete;

    std::string_view view() const { return text_; }
    bool was_converted() const { return !converted_.empty(); }

private:
    std::string converted_;
    std::string_view text_;
};

/// A text without the padding of a block at its end: zero bytes, and the end-of-file character of DOS. Noted.
std::string_view without_padding(std::string_view text, ReadingNotes& notes);

}  // namespace kerf::core::io
