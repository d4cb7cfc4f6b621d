#pragma once

#include <cstdint>

namespace kerf::bench {

/// Lets the machine have memory at hand for work on a mesh of so many triangles, by writing to that much and giving it
/// back. The host of a virtual machine takes free memory away after some seconds, and the first use of what it took costs
/// 9 us for 4 KiB, several times what the system takes to hand a page out: so much that whether a program has just freed
/// memory decides how long the next thing takes. To be called before what is timed; takes as long as the host needs. If it
/// has just done so for at least as many triangles, it does nothing: a short benchmark repeats thousands of times. Does
/// nothing where there is no mmap().
void have_memory_for(std::uint64_t triangles);

}  // namespace kerf::bench
