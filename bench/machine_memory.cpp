#include "bench/machine_memory.h"

#ifdef __linux__
#include <sys/mman.h>

#include <chrono>
#include <cstddef>
#endif

namespace kerf::bench {

void have_memory_for([[maybe_unused]] std::uint64_t triangles)
{
#ifdef __linux__
    using Clock = std::chrono::steady_clock;
    constexpr auto kKept = std::chrono::milliseconds(500);  // hosts leave free memory alone for longer than that
    static Clock::time_point at_hand_until{};
    static std::uint64_t at_hand_for = 0;
    if (triangles <= at_hand_for && Clock::now() < at_hand_until) return;

    constexpr std::size_t kBytesOfATriangle = 600;  // a mesh, an object, and what is needed meanwhile
    const std::size_t bytes = kBytesOfATriangle * triangles;
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
#ifdef MADV_HUGEPAGE
    madvise(memory, bytes, MADV_HUGEPAGE);  // as large arrays are; an advice, whatever becomes of it
#endif
    constexpr std::size_t kPage = 4096;
    for (std::size_t i = 0; i < bytes; i += kPage) static_cast<volatile char*>(memory)[i] = 1;
    munmap(memory, bytes);
    at_hand_for = triangles;
    at_hand_until = Clock::now() + kKept;
#endif
}

}  // namespace kerf::bench
