#include "bench/machine_memory.h"

#ifdef __linux__
#include <sys/mman.h>

#include <cstddef>
#endif

namespace kerf::bench {

void have_memory_for([[maybe_unused]] std::uint64_t triangles)
{
#ifdef __linux__
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
#endif
}

}  // namespace kerf::bench
