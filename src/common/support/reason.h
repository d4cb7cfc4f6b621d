#pragma once

#include <cstdint>
#include <string>
#include <string_view>

// Words of the sentences that say what is wrong with an input.

namespace kerf {

/// A piece of the input, a name or a word: in quotes, shortened, without control characters.
std::string in_quotes(std::string_view text);

/// ", but there are only 4, counted from 0", for an index of things that there are `count` of.
std::string but_there_are_only(std::uint64_t count);

}  // namespace kerf
