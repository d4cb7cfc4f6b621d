#pragma once

#include <cstddef>

namespace kerf::core::halfedge {

/// Bytes of a large page, where there are any.
inline constexpr std::size_t kHugePage = std::size_t(1) << 21;

/// Arrays from so many bytes on end with a whole huge page.
inline constexpr std::size_t kFewHugePages = kHugePage + kHugePage / 2;

/// Asks the operating system to back a large block by large pages, before it is touched: a cut reads a little
/// everywhere, and with small pages half of its time goes into looking up addresses. No effect on a system that has no
/// such request, or on small blocks.
void prefer_huge_pages(void* begin, std::size_t bytes);

}  // namespace kerf::core::halfedge
