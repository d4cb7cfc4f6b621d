#pragma once

#include <algorithm>
#include <cstddef>
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
/// for each smaller point, buckets are sorted as they are visited. O(n) for bounded valence, O(n log n) otherwise.
class HalfedgesByEdge
{
public:
    /// `corners` holds the three point ids of each triangle, all below `point_count`.
    HalfedgesByEdge(std::uint32_t point_count, std::span<const Triangle> corners);

    /// One half-edge in its bucket.
    struct Entry
    {
        std::uint32_t larger_point;
        std::uint32_t halfedge;
    };

    /// Calls visit(std::span<const Entry>) for each undirected edge, until one of them returns false; returns whether all
    /// have been visited. Never an empty span.
    template <class Visit>
    bool for_each_while(Visit&& visit)
    {
        Entry* first = entries_.data();
        for (std::size_t bucket = 0; bucket < bucket_end_.size(); ++bucket) {
            Entry* const bucket_end = entries_.data() + bucket_end_[bucket];
            // Only now: what is sorted is read at once, while it lies in the cache.
            sort_bucket(first, bucket_end);
            while (first != bucket_end) {
                const Entry* last = first + 1;
                while (last != bucket_end && last->larger_point == first->larger_point) ++last;
                if (!visit(std::span<const Entry>(first, last))) return false;
                first += last - first;
            }
        }
        return true;
    }

    /// The same for all edges.
    template <class Visit>
    void for_each(Visit&& visit)
    {
        for_each_while([&](std::span<const Entry> edge) {
            visit(edge);
            return true;
        });
    }

private:
    /// Most buckets hold half a dozen half-edges: insertion beats std::sort there. Hubs of fans get std::sort.
    static constexpr std::ptrdiff_t kInsertionSortLimit = 24;

    static void sort_bucket(Entry* first, Entry* last)
    {
        if (last - first > kInsertionSortLimit) return sort_large_bucket(first, last);
        if (last - first == 6) return sort_six(first);
        for (Entry* next = first; next < last; ++next) {
            const Entry entry = *next;
            Entry* hole = next;
            // Half-edges arrive in ascending order, so the larger point alone decides.
            for (; hole != first && (hole - 1)->larger_point > entry.larger_point; --hole) *hole = *(hole - 1);
            *hole = entry;
        }
    }
    /// A point inside a regular part of a mesh has three neighbours with larger numbers. Without a branch.
    static void sort_six(Entry* entries)
    {
        std::uint64_t key[6];
        for (std::size_t i = 0; i < 6; ++i) key[i] = std::uint64_t{entries[i].larger_point} << 32 | entries[i].halfedge;
        const auto order = [&](std::size_t i, std::size_t j) {
            const std::uint64_t a = key[i], b = key[j];
            key[i] = a < b ? a : b;
            key[j] = a < b ? b : a;
        };
        order(0, 5), order(1, 3), order(2, 4);
        order(1, 2), order(3, 4);
        order(0, 3), order(2, 5);
        order(0, 1), order(2, 3), order(4, 5);
        order(1, 2), order(3, 4);
        for (std::size_t i = 0; i < 6; ++i)
            entries[i] = {static_cast<std::uint32_t>(key[i] >> 32), static_cast<std::uint32_t>(key[i])};
    }
    static void sort_large_bucket(Entry* first, Entry* last);

    Buffer<Entry> entries_;             ///< by bucket; a bucket is sorted when it is visited
    Buffer<std::uint32_t> bucket_end_;  ///< for each smaller point the end of its bucket in entries_
};

}  // namespace kerf::core
