#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/pair_table.h"
#include "common/mesh/index.h"

namespace kerf::core::halfedge {

/// A number for each element of a universe, kNone at first: a table, or a hash table if few of many are asked for.
class NumberTable
{
public:
    /// @param expected  elements that will be asked for, about
    NumberTable(std::size_t elements, std::size_t expected) : is_sparse_(expected < elements / 16)
    {
        if (is_sparse_)
            few_.reset(expected);
        else
            all_.assign(elements, kNone);
    }

    /// Valid until another one is asked for; the caller gives it a number.
    Index& operator()(Index element) { return is_sparse_ ? few_(element, 0) : all_[element]; }

private:
    bool is_sparse_;
    std::vector<Index> all_;
    PairTable few_;  ///< of (element, 0)
};

}  // namespace kerf::core::halfedge
