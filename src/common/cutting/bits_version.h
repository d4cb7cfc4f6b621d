#pragma once

#include <cstdint>

namespace kerf::core {

/// The version of the results' bits. "The same object and the same plane give the same bytes" holds as long as this
/// number stays: for every back end, compiler, optimisation and machine with IEEE floats that Kerf supports. A release
/// in which a surface, a cap or a written file gets other bytes has a higher number, and the change log says which
/// bytes. Whoever keeps results beside their inputs (a cache, a replay, a lockstep game) keeps this number, too.
///
/// tests/contract/bits_test.cpp compares surfaces, caps and written files with what is recorded for this number.
std::uint32_t bits_version() noexcept;

}  // namespace kerf::core
