#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kerf::core::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A promise held against arbitrary bytes. Whatever the bytes are, `run` returns: a crash, a sanitizer's report, an
/// exception (require.h) or a time of more than ten seconds is a finding.
struct Fuzzer
{
    std::string_view name;  ///< its seeds lie in seeds/NAME
    void (*run)(Bytes bytes);
    std::size_t longest;  ///< bytes worth trying: longer inputs only take longer
};

/// All fuzzers of this build, by name.
std::span<const Fuzzer> fuzzers();

/// Null when there is none of this name.
const Fuzzer* find_fuzzer(std::string_view name);

}  // namespace kerf::core::fuzz
