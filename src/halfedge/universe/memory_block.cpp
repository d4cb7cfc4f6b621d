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

// How many times what it is made for a block has addresses for: a game cuts an object to a few times its size before it is
// compacted. Of small blocks glibc keeps what is up to 32 MB. The other numbers are for a system that gives out few addresses.
constexpr std::size_t kRoomOfSmall = 16, kLittleRoomOfSmall = 4;

#ifdef __linux__
constexpr std::size_t kRoom = 256, kLittleRoom = 8;  // of 47 bits of addresses

bool addresses_are_short(std::size_t bytes)
{
    // Asking takes a tenth of a microsecond, and there are twenty blocks in an object.
    constexpr std::size_t kNeverShort = std::size_t(1) << 16;
    if (bytes < kNeverShort) return false;
    rlimit limit{};
    return getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

std::size_t page_size()
{
    static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return size;
}

std::size_t whole(std::size_t unit, std::size_t bytes)
{
    return (bytes + unit - 1) / unit * unit;
}

/// A block that has something already and gets less than a huge page grows by so many bytes at least: the system finds
/// several pages at once in less time than one after the other. More of them would cost a short cut more than its section
/// does.
constexpr std::size_t kStep = std::size_t(1) << 15;

/// Asks for pages before they are touched, which costs less than a fault for each. Where there is no such request, they
/// come when they are touched.
void have_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes)
{
#ifdef MADV_POPULATE_WRITE
    static_cast<void>(madvise(begin, bytes, MADV_POPULATE_WRITE));
#endif
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
    const bool is_short = addresses_are_short(bytes);
    if (bytes >= kLeastMapped) {
        if (bytes > static_cast<std::size_t>(-1) / (2 * kRoom)) throw std::bad_alloc();
        for (const std::size_t room : {is_short ? kLittleRoom : kRoom, kLittleRoom, std::size_t(1)}) {
            if (begin_ != nullptr) break;
            reserved_ = whole(page_size(), room * bytes);
            begin_ = addresses(reserved_);
        }
        if (begin_ == nullptr) throw std::bad_alloc();
        is_mapped_ = true;
        return;
    }
#else
    const bool is_short = bytes >= kLeastMapped;
#endif
    for (const std::size_t room : {is_short ? kLittleRoomOfSmall : kRoomOfSmall, std::size_t(1)}) {
        if (bytes > static_cast<std::size_t>(-1) / room) continue;
        reserved_ = committed_ = room * bytes;
        begin_ = ::operator new(reserved_, std::nothrow);
        if (begin_ != nullptr) return;
    }
    throw std::bad_alloc();
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
        // A huge page is cleared at once, a quarter of a millisecond: too much for the one cut of a chain to which it
        // falls. What is asked for at once is worth it, little more is not.
        const bool is_little = committed_ > 0 && bytes - committed_ < kHugePage;
        const std::size_t unit = is_little ? kStep : bytes < kFewHugePages ? page_size() : kHugePage;
        const std::size_t wanted = std::min(reserved_, whole(unit, bytes));
        char* const from = static_cast<char*>(begin_) + committed_;
        if (mprotect(from, wanted - committed_, PROT_READ | PROT_WRITE) != 0) return false;
        if (is_little)
            have_pages(from, wanted - committed_);
        else
            prefer_huge_pages(from, wanted - committed_);
        committed_ = wanted;
    }
#endif
    return true;
}

}  // namespace kerf::core::halfedge
