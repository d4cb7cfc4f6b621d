#pragma once

#include <cstddef>

namespace kerf::test {

/// Bytes asked of operator new since the program started, and the largest single request since reset_largest().
std::size_t allocated_bytes();
std::size_t largest_allocation();
void reset_largest_allocation();

}  // namespace kerf::test
