#pragma once

#include <cstddef>
#include <utility>

namespace kerf::core::halfedge {

/// A run of memory that can grow where it stands: it has addresses for many times what it is made for. They are reserved
/// and cost no memory until commit() asks for some of it, or, in a small block, until they are written to.
class MemoryBlock
{
public:
    /// Bytes: a block that is made for less is ordinary memory, which the allocator keeps when the block ends, touched as
    /// it is, so that the next object takes it over; pages of a new mapping are touched for the first time.
    static constexpr std::size_t kLeastMapped = std::size_t(1) << 21;

    MemoryBlock() = default;
    /// Reserves addresses for at least `bytes`, none of which may be used yet; for many times as many, if there are.
    /// Throws std::bad_alloc.
    explicit MemoryBlock(std::size_t bytes);
    ~MemoryBlock();
    MemoryBlock(MemoryBlock&& other) noexcept
        : begin_(std::exchange(other.begin_, nullptr)),
          reserved_(std::exchange(other.reserved_, 0)),
          committed_(std::exchange(other.committed_, 0)),
          is_mapped_(std::exchange(other.is_mapped_, false))
    {
    }
    MemoryBlock& operator=(MemoryBlock&& other) noexcept
    {
        std::swap(begin_, other.begin_);
        std::swap(reserved_, other.reserved_);
        std::swap(committed_, other.committed_);
        std::swap(is_mapped_, other.is_mapped_);
        return *this;
    }

    void* begin() const { return begin_; }
    std::size_t reserved() const { return reserved_; }

    /// Makes the first `bytes` usable; false if there is no memory, or more than is reserved. What was usable stays as
    /// it is and where it is.
    bool commit(std::size_t bytes);

private:
    void* begin_ = nullptr;
    std::size_t reserved_ = 0, committed_ = 0;
    bool is_mapped_ = false;
};

}  // namespace kerf::core::halfedge
