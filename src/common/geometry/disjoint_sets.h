#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "common/mesh/buffer.h"

namespace kerf::core {

/// Union-find over 0..n-1 with path halving. The representative of a set is its smallest element, so that results do
/// not depend on the order of unions.
class DisjointSets
{
public:
    explicit DisjointSets(std::uint32_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

    /// Adds a set of one element, whose number it returns.
    std::uint32_t add()
    {
        parent_.push_back(size());
        return size() - 1;
    }

    void clear() { parent_.clear(); }
    void reserve(std::size_t count) { parent_.reserve(count); }

    std::uint32_t size() const { return static_cast<std::uint32_t>(parent_.size()); }

    std::uint32_t find(std::uint32_t i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void unite(std::uint32_t a, std::uint32_t b) { unite_representatives(find(a), find(b)); }

    /// The same for two sets whose representatives are known. Returns the representative of both.
    std::uint32_t unite_representatives(std::uint32_t a, std::uint32_t b)
    {
        if (a > b) std::swap(a, b);
        parent_[b] = a;
        return a;
    }

private:
    Buffer<std::uint32_t> parent_;
};

}  // namespace kerf::core
