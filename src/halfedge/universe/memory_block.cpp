#include "halfedge/universe/memory_block.h"

#include <algorithm>
#include <cstdint>
#include <new>

#include "halfedge/universe/huge_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace kerf::core::halfedge {

namespace {

#ifdef __linux__
/// How many times its size a block has addresses for. A game cuts an object to a few times its size before it is
/// compacted; addresses are not short: 47 bits of them.
constexpr std::size_t kRoom = 64;
/// The same where the system gives out few of them.
constexpr std::size_t kLittleRoom = 2;

bool addresses_are_short()
{
    rlimit limit{};
    return getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

std::size_t page_size()
{
    static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return size;
}

std::size_t whole_pages(std::size_t bytes)
{
    return (bytes + page_size() - 1) / page_size() * page_size();
}

/// A huge page is touched at once, and only if all of it may be.
std::size_t whole_huge_pages(std::size_t bytes)
{
    return (bytes + kHugePage - 1) / kHugePage * kHugePage;
}

/// So many bytes of addresses, whole pages, from a place where a huge page may begin; null if there are none.
void* addresses(std::size_t bytes)
{
    void* const mapped =
        mmap(nullptr, bytes + kHugePage, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (mapped == MAP_FAILED) return nullptr;
    char* const first = static_cast<char*>(mapped);
    const std::size_t before = (kHugePage - reinterpret_cast<std::uintptr_t>(first) % kHugePage) % kHugePage;
    if (before > 0) munmap(first, before);
    if (before < kHugePage) munmap(first + before + bytes, kHugePage - before);
    return first + before;
}
#endif

}  // namespace

MemoryBlock::MemoryBlock(std::size_t bytes)
{
#ifdef __linux__
    if (bytes >= kLeastMapped) {
        if (bytes > static_cast<std::size_t>(-1) / (2 * kRoom)) throw std::bad_alloc();
        for (const std::size_t room : {kRoom, kLittleRoom, std::size_t(1)}) {
            if (begin_ != nullptr || (room == kRoom && addresses_are_short())) continue;
            reserved_ = whole_pages(room * bytes);
            begin_ = addresses(reserved_);
        }
        if (begin_ == nullptr) throw std::bad_alloc();
        is_mapped_ = true;
        return;
    }
#endif
    begin_ = ::operator new(bytes);
    reserved_ = committed_ = bytes;
}

MemoryBlock::~MemoryBlock()
{
#ifdef __linux__
    if (is_mapped_) {
        munmap(begin_, reserved_);
        return;
    }
#endif
    ::operator delete(begin_);
}

bool MemoryBlock::commit(std::size_t bytes)
{
    if (bytes > reserved_) return false;
#ifdef __linux__
    if (is_mapped_ && bytes > committed_) {
        const std::size_t wanted =
            std::min(reserved_, bytes < kFewHugePages ? whole_pages(bytes) : whole_huge_pages(bytes));
        char* const from = static_cast<char*>(begin_) + committed_;
        if (mprotect(from, wanted - committed_, PROT_READ | PROT_WRITE) != 0) return false;
        prefer_huge_pages(from, wanted - committed_);
        committed_ = wanted;
    }
#endif
    return true;
}

}  // namespace kerf::core::halfedge
