#include "common/repair/adjacency.h"

#include <vector>

namespace kerf::core {

Index label_shells(std::span<const Index> opposite, Buffer<Index>& shell)
{
    const auto n = static_cast<Index>(opposite.size() / 3);
    shell.assign(n, kNone);
    Index count = 0;
    std::vector<Index> stack;
    for (Index first = 0; first < n; ++first) {
        if (shell[first] != kNone) continue;
        shell[first] = count;
        stack.push_back(first);
        while (!stack.empty()) {
            const Index t = stack.back();
            stack.pop_back();
            for (Index h = 3 * t; h < 3 * t + 3; ++h) {
                const Index across = opposite[h];
                if (across == kNone || shell[across / 3] != kNone) continue;
                shell[across / 3] = count;
                stack.push_back(across / 3);
            }
        }
        ++count;
    }
    return count;
}

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

Adjacency adjacency_in_order(std::span<const Index> opposite, std::span<const Index> shell,
                             std::span<const Index> order)
{
    Adjacency adjacency;
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
