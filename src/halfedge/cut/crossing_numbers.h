#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/mesh/index.h"
#include "halfedge/universe/universe.h"

// Which crossing triangle a face is. FIND numbers the faces that cross, in the order in which it finds them; SPLIT asks
// for the numbers of their neighbours.

namespace kerf::core::halfedge {

/// The number of the crossing triangle that a face is, or kNone: of `count` that a cut has stamped.
inline Index stamped_number(const Universe& universe, FaceId face, std::uint64_t count)
{
    const std::uint64_t stamp = universe.stamp_of_face[face];
    return stamp >= universe.stamp_base && stamp - universe.stamp_base < count
               ? static_cast<Index>(stamp - universe.stamp_base)
               : kNone;
}

/// The numbers of a cut: stamps in the universe, one for each face. O(1), and one access to memory.
class FaceStamps
{
public:
    explicit FaceStamps(Universe& universe) : u_(universe) {}

    /// Notes the next crossing triangle.
    void add(FaceId face) { u_.stamp_of_face[face] = static_cast<Index>(u_.stamp_base + count_++); }

    /// The number of the crossing triangle that a face is, or kNone.
    Index of(FaceId face) const { return stamped_number(u_, face, count_); }

    void prefetch(FaceId face) const { __builtin_prefetch(&u_.stamp_of_face[face]); }

private:
    Universe& u_;
    std::uint64_t count_ = 0;
};

/// The numbers of a section, which changes nothing: a hash table with linear probing, at most half full. Expected O(1).
class FaceTable
{
public:
    FaceTable() { clear(); }

    /// Forgets all. O(entries of the largest section so far).
    void clear()
    {
        if (entries_.empty()) entries_.resize(kFewEntries);
        if (count_ > 0) entries_.assign(entries_.size(), Entry{});
        count_ = 0;
    }

    /// Notes the next crossing triangle. May throw std::bad_alloc.
    void add(FaceId face)
    {
        if (2 * (count_ + 1) > entries_.size()) grow_to(2 * entries_.size());
        insert({number_of(face), static_cast<Index>(count_++)});
    }

    /// The number of the crossing triangle that a face is, or kNone.
    Index of(FaceId face) const
    {
        for (std::size_t i = place_of(number_of(face));; i = (i + 1) & (entries_.size() - 1))
            if (entries_[i].face == number_of(face) || entries_[i].face == kNone) return entries_[i].number;
    }

    void prefetch(FaceId face) const { __builtin_prefetch(&entries_[place_of(number_of(face))]); }

private:
    struct Entry
    {
        Index face = kNone, number = kNone;
    };
    static constexpr std::size_t kFewEntries = 64;

    static Index number_of(FaceId face) { return static_cast<Index>(face.idx()); }

    std::size_t place_of(Index face) const
    {
        constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;  // 2^64 / golden ratio (Knuth, vol. 3, 6.4)
        return (face * kOdd >> 32) & (entries_.size() - 1);
    }

    void insert(const Entry& entry)
    {
        std::size_t i = place_of(entry.face);
        while (entries_[i].face != kNone) i = (i + 1) & (entries_.size() - 1);
        entries_[i] = entry;
    }

    void grow_to(std::size_t size)
    {
        std::vector<Entry> old(size);
        old.swap(entries_);
        for (const Entry& entry : old)
            if (entry.face != kNone) insert(entry);
    }

    std::vector<Entry> entries_;  // a power of two of them
    std::size_t count_ = 0;
};

}  // namespace kerf::core::halfedge
