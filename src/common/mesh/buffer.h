#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace kerf::core {

/// Allocator that leaves trivial elements uninitialised on resize(): a linear cutter that zeroes 30 MB before it writes
/// them pays for the memory twice. Everything else is std::allocator.
template <class T>
struct UninitialisedAllocator : std::allocator<T>
{
    template <class U>
    struct rebind
    {
        using other = UninitialisedAllocator<U>;
    };

    UninitialisedAllocator() = default;
    template <class U>
    UninitialisedAllocator(const UninitialisedAllocator<U>&) noexcept
    {
    }

    template <class U>
    void construct(U* place) noexcept(std::is_nothrow_default_constructible_v<U>)
    {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Args>
    void construct(U* place, Args&&... args)
    {
        ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
    }
};

/// A std::vector whose resize() does not write the new elements of trivial types.
template <class T>
using Buffer = std::vector<T, UninitialisedAllocator<T>>;

}  // namespace kerf::core
