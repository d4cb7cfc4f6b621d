#include "common/duplicates.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace kerf {

namespace {

/// A triangle in the bucket of its smallest point: the other two in its orientation.
struct Entry
{
    std::uint32_t second, third, triangle;

    bool operator<(const Entry& other) const
    {
        return std::tie(second, third, triangle) < std::tie(other.second, other.third, other.triangle);
    }
};

}  // namespace

std::vector<TriangleFault> find_faults(std::uint32_t point_count, std::span<const Triangle> corners)
{
    std::vector<TriangleFault> faults(corners.size(), TriangleFault::none);
    Buffer<std::uint32_t> bucket_end(point_count, 0);
    for (std::size_t t = 0; t < corners.size(); ++t) {
        const auto& [a, b, c] = corners[t];
        if (a == b || b == c || c == a)
            faults[t] = TriangleFault::degenerate;
        else
            ++bucket_end[std::min({a, b, c})];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& slot : bucket_end) sum += std::exchange(slot, sum);

    Buffer<Entry> entries(sum);
    for (std::uint32_t t = 0; t < corners.size(); ++t) {
        if (faults[t] == TriangleFault::degenerate) continue;
        const auto& [a, b, c] = corners[t];
        if (a < b && a < c)
            entries[bucket_end[a]++] = {b, c, t};
        else if (b < c)
            entries[bucket_end[b]++] = {c, a, t};
        else
            entries[bucket_end[c]++] = {a, b, t};
    }
    std::uint32_t begin = 0;
    for (const std::uint32_t end : bucket_end) {
        if (end - begin > 1) {
            std::sort(entries.begin() + begin, entries.begin() + end);
            for (std::uint32_t i = begin + 1; i < end; ++i)
                if (entries[i].second == entries[i - 1].second && entries[i].third == entries[i - 1].third)
                    faults[entries[i].triangle] = TriangleFault::duplicate;
        }
        begin = end;
    }
    return faults;
}

}  // namespace kerf
