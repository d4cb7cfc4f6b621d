#pragma once

#include <cstddef>
#include <new>
#include <utility>

namespace kerf::core {

/// Memory of one cap's triangulation, freed as a whole. CGAL's containers lose a block if the next allocation fails
/// (Compact_container::allocate_new_block in CGAL 5.5); an arena loses nothing.
///
/// A thread allocates in the arena that it made last; arenas end in the reverse order.
class CapArena
{
public:
    CapArena() : before_(std::exchange(current(), this)) {}
    ~CapArena()
    {
        while (blocks_ != nullptr) ::operator delete(std::exchange(blocks_, blocks_->next));
        current() = before_;
    }
    CapArena(const CapArena&) = delete;
    CapArena& operator=(const CapArena&) = delete;

    /// Throws std::bad_alloc.
    static void* allocate(std::size_t bytes)
    {
        CapArena& arena = *current();
        auto* block = static_cast<Block*>(::operator new(sizeof(Block) + bytes));
        block->next = std::exchange(arena.blocks_, block);
        return block + 1;
    }

private:
    struct alignas(std::max_align_t) Block
    {
        Block* next;
    };

    static CapArena*& current()
    {
        thread_local CapArena* arena = nullptr;
        return arena;
    }

    CapArena* before_;
    Block* blocks_ = nullptr;
};

/// A standard allocator in the thread's arena, which must outlive what it allocates. Single blocks are not freed.
template <class T>
struct CapArenaAllocator
{
    using value_type = T;

    CapArenaAllocator() = default;
    template <class U>
    CapArenaAllocator(const CapArenaAllocator<U>&)
    {
    }

    T* allocate(std::size_t count)
    {
        static_assert(alignof(T) <= alignof(std::max_align_t));
        return static_cast<T*>(CapArena::allocate(count * sizeof(T)));
    }
    void deallocate(T*, std::size_t) {}

    friend bool operator==(const CapArenaAllocator&, const CapArenaAllocator&) { return true; }
};

}  // namespace kerf::core
