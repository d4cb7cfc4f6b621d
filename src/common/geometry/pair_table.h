#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/mesh/index.h"

namespace kerf::core {

/// Open-addressing hash table from a pair of ids to an id: O(1) per look-up, no removal.
class PairTable
{
public:
    /// Empties the table and makes room for `count` entries.
    void reset(std::size_t count)
    {
        slots_.assign(std::bit_ceil(count * 2 + 2), Slot{});
        mask_ = slots_.size() - 1;
        size_ = 0;
    }

    /// The value stored for (a, b). If there is none yet it is kNone, and the caller stores one.
    std::uint32_t& operator()(std::uint32_t a, std::uint32_t b)
    {
        const std::uint64_t key = (std::uint64_t(a) << 32) | b;
        if ((size_ + 1) * 2 > slots_.size()) grow();
        std::size_t i = hash(key) & mask_;
        while (slots_[i].value != kNone && slots_[i].key != key) i = (i + 1) & mask_;
        if (slots_[i].value == kNone) {
            slots_[i].key = key;
            ++size_;
        }
        return slots_[i].value;
    }

    /// The value stored for (a, b), or kNone.
    std::uint32_t find(std::uint32_t a, std::uint32_t b) const
    {
        const std::uint64_t key = (std::uint64_t(a) << 32) | b;
        std::size_t i = hash(key) & mask_;
        while (slots_[i].value != kNone && slots_[i].key != key) i = (i + 1) & mask_;
        return slots_[i].value;
    }

private:
    struct Slot
    {
        std::uint64_t key = 0;
        std::uint32_t value = kNone;
    };

    /// Finaliser of MurmurHash3 (Appleby): every bit of the key reaches every bit of the hash.
    static std::size_t hash(std::uint64_t x)
    {
        x ^= x >> 33;
        x *= 0xff51afd7ed558ccdull;
        x ^= x >> 33;
        x *= 0xc4ceb9fe1a85ec53ull;
        x ^= x >> 33;
        return static_cast<std::size_t>(x);
    }

    void grow()
    {
        std::vector<Slot> old(slots_.size() * 2);
        old.swap(slots_);
        mask_ = slots_.size() - 1;
        for (const Slot& slot : old) {
            if (slot.value == kNone) continue;
            std::size_t i = hash(slot.key) & mask_;
            while (slots_[i].value != kNone) i = (i + 1) & mask_;
            slots_[i] = slot;
        }
    }

    std::vector<Slot> slots_ = std::vector<Slot>(2);
    std::size_t mask_ = 1;
    std::size_t size_ = 0;
};

}  // namespace kerf::core
