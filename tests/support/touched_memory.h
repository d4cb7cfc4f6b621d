#pragma once

#include <cstddef>
#include <optional>

namespace kerf::test {

/// From now on this process gets small pages only, so that touched_memory() is exact to a page.
void use_small_pages();

/// Forgets which pages were read or written so far. False where the system can't do that.
bool forget_touched_memory();

/// Bytes in pages that this process, program text and stack included, has read or written since
/// forget_touched_memory(): whatever they were asked from. Empty where the system does not say.
std::optional<std::size_t> touched_memory();

/// How often this thread has touched a page that the system had to find for it; always 0 where the system does not say.
std::size_t page_faults();

}  // namespace kerf::test

namespace kerf::core::test {
using namespace kerf::test;
}
