#include "support/allocations.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

std::size_t total = 0, largest = 0;
std::uint64_t calls = 0, reallocation_calls = 0;

constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();
std::uint64_t until_failure = kNever;
bool has_failed = false, fails_for_good = false;

/// Counts an allocation; false when it is to fail.
bool may_allocate(std::size_t size)
{
    if (until_failure != kNever && until_failure-- == 0) {
        until_failure = fails_for_good ? 0 : kNever;
        has_failed = true;
        return false;
    }
    ++calls;
    total += size;
    largest = std::max(largest, size);
    return true;
}

/// Null when there is no memory, or when this allocation is to fail.
void* counted(std::size_t size)
{
    return may_allocate(size) ? std::malloc(size > 0 ? size : 1) : nullptr;
}
void* counted(std::size_t size, std::align_val_t alignment)
{
    const auto align = static_cast<std::size_t>(alignment);
    return may_allocate(size) ? std::aligned_alloc(align, (size + align - 1) / align * align) : nullptr;
}

}  // namespace

void* operator new(std::size_t size)
{
    if (void* p = counted(size)) return p;
    throw std::bad_alloc();
}
void* operator new[](std::size_t size)
{
    return operator new(size);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
    if (void* p = counted(size, alignment)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p, std::align_val_t) noexcept
{
    std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
    std::free(p);
}
// Sorting asks for its buffer in this way.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    return counted(size);
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept
{
    return operator new(size, tag);
}
void operator delete(void* p, const std::nothrow_t&) noexcept
{
    std::free(p);
}
void operator delete[](void* p, const std::nothrow_t&) noexcept
{
    std::free(p);
}
void operator delete(void* p) noexcept
{
    std::free(p);
}
void operator delete[](void* p) noexcept
{
    std::free(p);
}
void operator delete(void* p, std::size_t) noexcept
{
    std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept
{
    std::free(p);
}

// The linker's names (--wrap=realloc): calls of realloc() go to the first, the second is the library's.
// NOLINTBEGIN(bugprone-reserved-identifier): the linker prescribes them
extern "C" {
void* __real_realloc(void* block, std::size_t size);
void* __wrap_realloc(void* block, std::size_t size)
{
    ++reallocation_calls;
    return may_allocate(size) ? __real_realloc(block, size) : nullptr;
}
}
// NOLINTEND(bugprone-reserved-identifier)

namespace kerf::test {

std::size_t allocated_bytes()
{
    return total;
}
std::uint64_t allocations()
{
    return calls;
}
std::uint64_t reallocations()
{
    return reallocation_calls;
}
std::size_t largest_allocation()
{
    return largest;
}
void reset_largest_allocation()
{
    largest = 0;
}

FailingAllocation::FailingAllocation(std::uint64_t number, Failure failure)
{
    fails_for_good = failure == Failure::for_good;
    until_failure = number;
    has_failed = false;
}
FailingAllocation::~FailingAllocation()
{
    until_failure = kNever;
}
bool FailingAllocation::happened() const
{
    return has_failed;
}

}  // namespace kerf::test
