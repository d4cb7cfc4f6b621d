#pragma once

#include <cstddef>
#include <span>

#include "halfedge/universe/universe.h"

// Leaves that the plane meets lie anywhere in memory. It answers only some twenty requests at a time: who asks for all
// of a leaf at once waits for the answers, who asks a little at each step of other work does not.

namespace kerf::core::halfedge {

inline void prefetch(const Node& node)
{
    __builtin_prefetch(&node);
    __builtin_prefetch(reinterpret_cast<const char*>(&node + 1) - 1);
}

inline void prefetch(const void* begin, std::size_t bytes)
{
    constexpr std::size_t kCacheLine = 64;
    for (std::size_t i = 0; i < bytes; i += kCacheLine) __builtin_prefetch(static_cast<const char*>(begin) + i);
}

/// Asks for the triangles of a leaf that is to be read later, a little at a time.
class TrianglePrefetch
{
public:
    explicit TrianglePrefetch(const Universe& universe) : u_(universe) {}

    void aim_at(const Node& leaf) { first_ = leaf.first, count_ = leaf.count; }
    void aim_at_none() { count_ = 0; }

    /// For i from 0 on, as many steps as the leaf has triangles.
    void step(std::uint32_t i) const
    {
        if (i >= count_) return;
        __builtin_prefetch(&u_.slots[first_ + i]);
        __builtin_prefetch(&u_.face_of_slot[first_ + i]);
    }

private:
    const Universe& u_;
    SlotId first_;
    std::uint32_t count_ = 0;
};

/// Asks for the vertices of a leaf whose triangles are there, a little at a time.
class VertexPrefetch
{
public:
    explicit VertexPrefetch(const Universe& universe) : u_(universe) {}

    void aim_at(const Node& leaf) { triangles_ = {&u_.slots[leaf.first], leaf.count}; }
    void aim_at_none() { triangles_ = {}; }

    /// For i from 0 on, as many steps as the leaf has triangles.
    void step(std::uint32_t i) const
    {
        if (i >= triangles_.size()) return;
        for (const Index v : triangles_[i]) __builtin_prefetch(&u_.vertices[v]);
    }

private:
    const Universe& u_;
    std::span<const Triangle> triangles_;
};

}  // namespace kerf::core::halfedge
