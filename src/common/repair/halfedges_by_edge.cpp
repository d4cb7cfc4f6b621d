#include "common/repair/halfedges_by_edge.h"

namespace kerf::core {

HalfedgesByEdge::HalfedgesByEdge(std::uint32_t point_count, std::span<const Triangle> corners)
{
    // Count into the slot of each smaller point, turn counts into starts, scatter: the starts end up as ends.
    bucket_end_.assign(point_count, 0);
    for (const auto& [a, b, c] : corners) {
        ++bucket_end_[std::min(a, b)];
        ++bucket_end_[std::min(b, c)];
        ++bucket_end_[std::min(c, a)];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& slot : bucket_end_) sum += std::exchange(slot, sum);

    entries_.resize(corners.size() * 3);
    std::uint32_t halfedge = 0;
    for (const auto& [a, b, c] : corners) {
        entries_[bucket_end_[std::min(a, b)]++] = {std::max(a, b), halfedge++};
        entries_[bucket_end_[std::min(b, c)]++] = {std::max(b, c), halfedge++};
        entries_[bucket_end_[std::min(c, a)]++] = {std::max(c, a), halfedge++};
    }
}

void HalfedgesByEdge::sort_large_bucket(Entry* first, Entry* last)
{
    std::sort(first, last, [](const Entry& a, const Entry& b) {
        return a.larger_point != b.larger_point ? a.larger_point < b.larger_point : a.halfedge < b.halfedge;
    });
}

}  // namespace kerf::core
