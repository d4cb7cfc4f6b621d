#include "common/repair/adjacency.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/geometry/disjoint_sets.h"

namespace kerf::core {

namespace {

/// The opposite half-edges after a reordering: triangle i is the old triangle order[i].
Buffer<Index> opposite_in_order(std::span<const Index> opposite, std::span<const Index> order)
{
    Buffer<Index> place(order.size());
    for (Index i = 0; i < order.size(); ++i) place[order[i]] = i;
    Buffer<Index> result(3 * order.size());
    for (Index i = 0; i < order.size(); ++i)
        for (Index corner = 0; corner < 3; ++corner) {
            const Index across = opposite[3 * order[i] + corner];
            result[3 * i + corner] = across == kNone ? kNone : 3 * place[across / 3] + across % 3;
        }
    return result;
}

bool changes_nothing(std::span<const Index> order)
{
    for (Index i = 0; i < order.size(); ++i)
        if (order[i] != i) return false;
    return true;
}

}  // namespace

Index label_shells(std::span<const Index> opposite, Buffer<Index>& shell)
{
    // Each edge once, from its later triangle. Going through triangles in order reads memory in order, which a search
    // from neighbour to neighbour does not.
    const auto n = static_cast<Index>(opposite.size() / 3);
    DisjointSets sets(n);
    for (Index t = 0; t < n; ++t) {
        Index first = t;  // of the shell that the triangle joins
        for (Index corner = 0; corner < 3; ++corner) {
            const Index across = opposite[3 * t + corner];
            if (across >= 3 * t) continue;
            const Index other = sets.find(across / 3);
            if (other != first) first = sets.unite_representatives(first, other);
        }
    }
    shell.resize(n);
    Index count = 0;
    for (Index t = 0; t < n; ++t) {
        const Index first = sets.find(t);
        shell[t] = first == t ? count++ : shell[first];
    }
    return count;
}

Adjacency adjacency_in_order(Buffer<Index> opposite, Buffer<Index> shell, std::span<const Index> order)
{
    Adjacency adjacency;
    if (changes_nothing(order)) {
        for (const Index number : shell) adjacency.shell_count = std::max(adjacency.shell_count, number + 1);
        adjacency.opposite = std::move(opposite);
        adjacency.shell = std::move(shell);
        return adjacency;
    }
    adjacency.opposite = opposite_in_order(opposite, order);
    adjacency.shell.resize(order.size());
    std::vector<Index> number;  // by old number
    for (Index i = 0; i < order.size(); ++i) {
        const Index old = shell[order[i]];
        if (old >= number.size()) number.resize(old + 1, kNone);
        if (number[old] == kNone) number[old] = adjacency.shell_count++;
        adjacency.shell[i] = number[old];
    }
    return adjacency;
}

}  // namespace kerf::core
