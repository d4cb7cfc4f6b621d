#include "common/geometry/containment.h"

#include <algorithm>
#include <numeric>

namespace kerf::core {

std::span<const std::uint32_t> SmallestContainers::find(std::span<const ContainableShape> items,
                                                        const DecideContainment& decide)
{
    container_.assign(items.size(), kNoContainer);
    if (items.size() < 2) return container_;

    by_size_.resize(items.size());
    rank_.resize(items.size());
    std::iota(by_size_.begin(), by_size_.end(), 0u);
    // Of two coincident items, the one that cannot contain anything lies in the other, whichever comes first: back ends
    // may order items at one place differently.
    std::sort(by_size_.begin(), by_size_.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (items[a].size != items[b].size) return items[a].size < items[b].size;
        return items[a].can_contain != items[b].can_contain ? items[b].can_contain : a > b;
    });
    for (std::uint32_t i = 0; i < by_size_.size(); ++i) rank_[by_size_[i]] = i;

    // An item whose box lies in another box has its lower corner there.
    corners_.clear();
    for (const ContainableShape& item : items) corners_.push_back(item.box.lo);
    waiting_.build(corners_);
    for (std::uint32_t i = 0; i < items.size(); ++i)
        if (!items[i].can_lie_in || items[i].box.empty()) waiting_.remove(i);

    for (const std::uint32_t outer : by_size_) {
        if (!items[outer].can_contain) continue;
        candidates_.clear();
        waiting_.for_each_in(items[outer].box, [&](std::uint32_t inner) {
            if (rank_[inner] < rank_[outer] && encloses(items[outer].box, items[inner].box))
                candidates_.push_back(inner);
        });
        if (candidates_.empty()) continue;
        lies_in_.assign(candidates_.size(), 0);
        decide(outer, candidates_, lies_in_);
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            if (!lies_in_[i]) continue;
            container_[candidates_[i]] = outer;
            waiting_.remove(candidates_[i]);
        }
    }
    return container_;
}

std::vector<std::uint32_t> smallest_containers(std::span<const ContainableShape> items, const DecideContainment& decide)
{
    SmallestContainers search;
    const std::span<const std::uint32_t> found = search.find(items, decide);
    return {found.begin(), found.end()};
}

void WindingNumbers::begin(std::span<const WindingSample> samples)
{
    samples_ = samples;
    positions_.clear();
    for (const WindingSample& sample : samples) positions_.push_back(sample.position);
    tree_.build(positions_);
    windings_.assign(samples.size(), 0);
}

void WindingNumbers::vote(std::span<std::uint8_t> lies_in)
{
    balance_.assign(lies_in.size(), 0);
    for (std::size_t i = 0; i < samples_.size(); ++i) balance_[samples_[i].candidate] += windings_[i] != 0 ? 1 : -1;
    for (std::size_t i = 0; i < lies_in.size(); ++i) lies_in[i] = balance_[i] > 0;
}

}  // namespace kerf::core
