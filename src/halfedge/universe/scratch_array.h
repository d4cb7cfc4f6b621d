#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

#include "halfedge/universe/huge_pages.h"

namespace kerf::core::halfedge {

/// A table of fixed size for one pass over a mesh, its elements unwritten. A large one begins and ends with a huge page,
/// so that all of it may lie on such: of a table that begins anywhere, some five hundred small pages are touched before
/// the first huge one and behind the last. Comes from the allocator, which keeps it for the next table. Elements are trivial to copy.
template <class T>
class ScratchArray
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    ScratchArray() = default;
    /// Throws std::bad_alloc.
    explicit ScratchArray(std::size_t size) : size_(size)
    {
        if (size > (static_cast<std::size_t>(-1) - kHugePage) / sizeof(T)) throw std::bad_alloc();
        data_ = static_cast<T*>(is_large() ? ::operator new(whole_huge_pages(), std::align_val_t(kHugePage))
                                           : ::operator new(size * sizeof(T)));
        if (is_large()) prefer_huge_pages(data_, whole_huge_pages());
    }
    ScratchArray(std::size_t size, const T& value) : ScratchArray(size) { std::fill(begin(), end(), value); }
    ~ScratchArray()
    {
        if (is_large())
            ::operator delete(data_, std::align_val_t(kHugePage));
        else
            ::operator delete(data_);
    }
    ScratchArray(ScratchArray&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0))
    {
    }
    ScratchArray& operator=(ScratchArray&& other) noexcept
    {
        swap(other);
        return *this;
    }
    void swap(ScratchArray& other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
    }

    std::size_t size() const { return size_; }
    T* data() { return data_; }
    const T* data() const { return data_; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }

private:
    /// With three quarters of a huge page or more. Clearing the rest of it costs less than so many small pages do.
    bool is_large() const { return size_ * sizeof(T) >= kHugePage / 4 * 3; }
    std::size_t whole_huge_pages() const { return (size_ * sizeof(T) + kHugePage - 1) / kHugePage * kHugePage; }

    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace kerf::core::halfedge
