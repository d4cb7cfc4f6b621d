#include "common/repair/halfedges_by_edge.h"

namespace kerf::core {

namespace {

/// Most buckets hold half a dozen half-edges: insertion beats std::sort there. Hubs of fans get std::sort.
constexpr std::size_t kInsertionSortLimit = 24;

bool before(const HalfedgesByEdge::Entry& a, const HalfedgesByEdge::Entry& b)
{
    return a.larger_point != b.larger_point ? a.larger_point < b.larger_point : a.halfedge < b.halfedge;
}

void sort_bucket(HalfedgesByEdge::Entry* first, HalfedgesByEdge::Entry* last)
{
    if (static_cast<std::size_t>(last - first) > kInsertionSortLimit) {
        std::sort(first, last, before);
        return;
    }
    for (HalfedgesByEdge::Entry* next = first; next < last; ++next) {
        const HalfedgesByEdge::Entry entry = *next;
        HalfedgesByEdge::Entry* hole = next;
        // Half-edges arrive in ascending order, so the larger point alone decides.
        for (; hole != first && (hole - 1)->larger_point > entry.larger_point; --hole) *hole = *(hole - 1);
        *hole = entry;
    }
}

}  // namespace

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
    std::uint32_t begin = 0;
    for (const std::uint32_t end : bucket_end_) {
        sort_bucket(entries_.data() + begin, entries_.data() + end);
        begin = end;
    }
}

}  // namespace kerf::core
