#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "common/io/reading_notes.h"

// JSON of glTF files, with the faults that other programs leave in it.

namespace kerf::core::io {

/// JSON text that cannot be read.
class JsonError : public std::runtime_error
{
public:
    explicit JsonError(std::size_t place) : std::runtime_error("malformed JSON"), byte(place) {}

    std::size_t byte;  ///< where, in the text as it was given
};

/// Parses JSON. Faults that programs write and that have a plain meaning are put right and noted:
/// * control characters inside strings (a raw TAB or line end) become spaces,
/// * bytes inside strings that are not UTF-8 are taken as Latin-1,
/// * NaN, infinities and numbers too large for a double become an empty string, so that whoever needs the number
///   refuses it.
///
/// Strict text is parsed once, other text twice. O(n), whatever the depth.
/// @throws JsonError
nlohmann::json parse_lenient_json(std::string_view text, ReadingNotes& notes);

}  // namespace kerf::core::io
