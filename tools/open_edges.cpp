#include "tools/open_edges.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace kerf::tools {

std::uint64_t open_edges(const FlatMesh& mesh)
{
    // Edges sorted into the lists of their smaller points, by counting; those lists are short.
    std::vector<std::size_t> first(std::size_t(mesh.point_count) + 1, 0);
    const auto for_each_edge = [&](auto&& visit) {
        for (const Triangle& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) visit(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]);
    };
    for_each_edge([&](std::uint32_t a, std::uint32_t b) { ++first[std::size_t(std::min(a, b)) + 1]; });
    for (std::size_t p = 0; p < mesh.point_count; ++p) first[p + 1] += first[p];

    std::vector<std::pair<std::uint32_t, int>> edges(3 * mesh.triangles.size());  // larger point, direction
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for_each_edge([&](std::uint32_t a, std::uint32_t b) {
        edges[next[std::min(a, b)]++] = {std::max(a, b), a < b ? 1 : -1};
    });

    std::uint64_t open = 0;
    for (std::size_t p = 0; p < mesh.point_count; ++p) {
        const auto end = edges.begin() + static_cast<std::ptrdiff_t>(first[p + 1]);
        auto at = edges.begin() + static_cast<std::ptrdiff_t>(first[p]);
        std::sort(at, end);
        while (at != end) {
            const std::uint32_t other = at->first;
            int balance = 0;
            for (; at != end && at->first == other; ++at) balance += at->second;
            open += static_cast<std::uint64_t>(balance < 0 ? -balance : balance);
        }
    }
    return open;
}

}  // namespace kerf::tools
