#pragma once

#include <cstdint>
#include <string>
#include <string_view>

// Phrases for the sentences that tell the fault of an input.

namespace kerf::core {

/// A name or a word of the input: in quotes, shortened, without control characters.
std::string in_quotes(std::string_view text);

/// ", but there are only 4, counted from 0": for an index out of range, if there are `count` things.
std::string but_there_are_only(std::uint64_t count);

}  // namespace kerf::core
