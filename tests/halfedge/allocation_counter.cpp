#include "halfedge/allocation_counter.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

std::size_t total = 0, largest = 0;

void* counted(std::size_t size)
{
    total += size;
    largest = std::max(largest, size);
    if (void* p = std::malloc(size > 0 ? size : 1)) return p;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size)
{
    return counted(size);
}
void* operator new[](std::size_t size)
{
    return counted(size);
}
// Sorting asks for its buffer in this way.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    try {
        return counted(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
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

namespace kerf::test {

std::size_t allocated_bytes()
{
    return total;
}
std::size_t largest_allocation()
{
    return largest;
}
void reset_largest_allocation()
{
    largest = 0;
}

}  // namespace kerf::test
