#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "halfedge/universe/ids.h"
#include "halfedge/universe/memory_block.h"

namespace kerf::core::halfedge {

/// An array that only grows at its end, in memory that has been written to before it is needed: the first touch of a
/// page costs more than the work of a cut on it. Elements beyond size() may be written up to capacity(); they become
/// part of the array by extend(), which can't fail. Elements are trivial.
///
/// A large buffer never moves: room behind it is reserved as addresses (memory_block.h) and touched bit by bit when it
/// runs out, so that the cost of growth depends on what is added, not on what is there. A small one has less room. If it
/// runs out, the elements are copied, and the old ones stay where they are until the buffer ends. So who reads elements
/// that were there once may go on while others are appended.
///
/// Key: what an element is found by, a number or an id.
template <class T, class Key = std::size_t>
class AppendBuffer
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    AppendBuffer() = default;
    ~AppendBuffer() = default;
    AppendBuffer(const AppendBuffer& other) : AppendBuffer()
    {
        reserve(other.capacity_, other.size_);
        std::copy_n(other.data_, other.size_, data_);
        size_ = other.size_;
    }
    AppendBuffer(AppendBuffer&& other) noexcept { swap(other); }
    AppendBuffer& operator=(AppendBuffer other) noexcept
    {
        swap(other);
        return *this;
    }
    void swap(AppendBuffer& other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        std::swap(blocks_, other.blocks_);
    }

    std::size_t size() const { return size_; }
    std::size_t capacity() const { return capacity_; }
    bool empty() const { return size_ == 0; }
    T* data() { return data_; }
    const T* data() const { return data_; }
    T& operator[](Key key) { return data_[number_of(key)]; }
    const T& operator[](Key key) const { return data_[number_of(key)]; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }

    /// Makes room for `capacity` elements in all and touches the new room, but not that of the first `written_soon`
    /// elements, which the caller is about to write. Throws std::bad_alloc, and is unchanged then.
    void reserve(std::size_t capacity, std::size_t written_soon = 0)
    {
        if (capacity <= capacity_) return;
        if (capacity > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_alloc();
        const std::size_t bytes = capacity * sizeof(T);
        if (blocks_.empty() || blocks_.back().reserved() < bytes) move_to_block_for(capacity);
        if (!blocks_.back().commit(bytes)) throw std::bad_alloc();
        const std::size_t first = std::max(capacity_, written_soon);
        // Not 0: the compiler would ask the system for zeroed memory, which comes untouched.
        if (first < capacity) std::memset(static_cast<void*>(data_ + first), 0xff, (capacity - first) * sizeof(T));
        capacity_ = capacity;
    }

    /// Makes room for `extra` more elements. Returns the bytes by which the buffer grew: 0 as long as reserved room
    /// lasts. O(extra), unless the memory that was asked for is used up.
    std::size_t make_room(std::size_t extra)
    {
        if (extra <= capacity_ - size_) return 0;
        const std::size_t before = capacity_;
        reserve(size_ + extra);
        return (capacity_ - before) * sizeof(T);
    }

    /// Counts elements beyond the end, which were written already, as part of the array.
    void extend(std::size_t count)
    {
        assert(count <= capacity_ - size_);
        size_ += count;
    }

    /// Sets the size within the capacity; new elements keep whatever bytes are there.
    void set_size(std::size_t size) { size_ = size; }

    /// Appends an element, for which there must be room.
    void push(const T& value)
    {
        assert(size_ < capacity_);
        data_[size_++] = value;
    }

    /// Bytes of touched memory.
    std::size_t bytes_reserved() const { return capacity_ * sizeof(T); }

private:
    /// Copies the elements to a new block. The old one stays.
    void move_to_block_for(std::size_t capacity)
    {
        MemoryBlock block(capacity * sizeof(T));
        if (!block.commit(capacity * sizeof(T))) throw std::bad_alloc();
        blocks_.reserve(blocks_.size() + 1);
        T* const data = static_cast<T*>(block.begin());
        if (capacity_ > 0) std::memcpy(static_cast<void*>(data), data_, capacity_ * sizeof(T));
        blocks_.push_back(std::move(block));
        data_ = data;
    }

    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;         ///< touched
    std::vector<MemoryBlock> blocks_;  ///< the last one holds the elements; the others held them once
};

}  // namespace kerf::core::halfedge
