#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "common/mesh/buffer.h"
#include "common/mesh/index.h"
#include "common/mesh/indexed_mesh.h"

namespace kerf::core {

// A half-edge is a triangle's side with a direction, numbered 3 * triangle + corner: it runs from that corner to the
// next one.

inline std::uint32_t next_halfedge(std::uint32_t h)
{
    return h % 3 == 2 ? h - 2 : h + 1;
}
inline std::uint32_t previous_halfedge(std::uint32_t h)
{
    return h % 3 == 0 ? h + 2 : h - 1;
}

/// The point where a half-edge starts. Triangles lie in memory corner by corner: half-edge h starts at the h-th corner of
/// all, without a division by three.
inline std::uint32_t start_of(std::span<const Triangle> corners, std::uint32_t h)
{
    static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
    return reinterpret_cast<const std::uint32_t*>(corners.data())[h];
}

/// The half-edges of some triangles, sorted so that those of one undirected edge follow one another: edges by smaller
/// point, then larger point, half-edges by number. Built by counting, without hashing: half-edges go into one bucket
/// for each smaller point, buckets are sorted. O(n) for bounded valence, O(n log n) otherwise.
class HalfedgesByEdge
{
public:
    /// `corners` holds the three point ids of each triangle, all below `point_count`.
    HalfedgesByEdge(std::uint32_t point_count, std::span<const Triangle> corners);

    /// Calls visit(std::span<const Entry>) for each undirected edge; never an empty span.
    template <class Visit>
    void for_each(Visit&& visit) const
    {
        const Entry* const end = entries_.data() + entries_.size();
        std::size_t bucket = 0;
        for (const Entry* first = entries_.data(); first != end;) {
            while (static_cast<std::uint32_t>(first - entries_.data()) >= bucket_end_[bucket]) ++bucket;
            const Entry* const bucket_end = entries_.data() + bucket_end_[bucket];
            const Entry* last = first + 1;
            while (last != bucket_end && last->larger_point == first->larger_point) ++last;
            visit(std::span<const Entry>(first, last));
            first = last;
        }
    }

    /// One half-edge in its bucket.
    struct Entry
    {
        std::uint32_t larger_point;
        std::uint32_t halfedge;
    };

private:
    Buffer<Entry> entries_;
    Buffer<std::uint32_t> bucket_end_;  ///< for each smaller point the end of its bucket in entries_
};

}  // namespace kerf::core
