#include "halfedge/universe/huge_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace kerf::core::halfedge {

void prefer_huge_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t from = (first + kHugePage - 1) & ~(kHugePage - 1), to = (first + bytes) & ~(kHugePage - 1);
    // Advice: whether it is taken or not makes no difference to what is computed.
    if (from < to) static_cast<void>(madvise(static_cast<char*>(begin) + (from - first), to - from, MADV_HUGEPAGE));
#endif
}

}  // namespace kerf::core::halfedge
