#include "common/geometry/containment.h"

#include <algorithm>
#include <numeric>

namespace kerf::core {

namespace {

std::vector<glm::vec3> positions_of(std::span<const WindingSample> samples)
{
    std::vector<glm::vec3> positions;
    positions.reserve(samples.size());
    for (const WindingSample& sample : samples) positions.push_back(sample.position);
    return positions;
}

}  // namespace

std::vector<std::uint32_t> smallest_containers(std::span<const ContainableShape> items, const DecideContainment& decide)
{
    std::vector<std::uint32_t> container(items.size(), kNoContainer);
    if (items.size() < 2) return container;

    std::vector<std::uint32_t> by_size(items.size()), rank(items.size());
    std::iota(by_size.begin(), by_size.end(), 0u);
    // Of two coincident items, the one that cannot contain anything lies in the other, whichever comes first: back ends
    // may order items at one place differently.
    std::sort(by_size.begin(), by_size.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (items[a].size != items[b].size) return items[a].size < items[b].size;
        return items[a].can_contain != items[b].can_contain ? items[b].can_contain : a > b;
    });
    for (std::uint32_t i = 0; i < by_size.size(); ++i) rank[by_size[i]] = i;

    // An item whose box lies in another box has its lower corner there.
    std::vector<glm::vec3> corners;
    corners.reserve(items.size());
    for (const ContainableShape& item : items) corners.push_back(item.box.lo);
    PointTree waiting(corners);
    for (std::uint32_t i = 0; i < items.size(); ++i)
        if (!items[i].can_lie_in || items[i].box.empty()) waiting.remove(i);

    std::vector<std::uint32_t> candidates;
    std::vector<std::uint8_t> lies_in;
    for (const std::uint32_t outer : by_size) {
        if (!items[outer].can_contain) continue;
        candidates.clear();
        waiting.for_each_in(items[outer].box, [&](std::uint32_t inner) {
            if (rank[inner] < rank[outer] && encloses(items[outer].box, items[inner].box)) candidates.push_back(inner);
        });
        if (candidates.empty()) continue;
        lies_in.assign(candidates.size(), 0);
        decide(outer, candidates, lies_in);
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            if (!lies_in[i]) continue;
            container[candidates[i]] = outer;
            waiting.remove(candidates[i]);
        }
    }
    return container;
}

WindingNumbers::WindingNumbers(std::span<const WindingSample> samples)
    : samples_(samples), positions_(positions_of(samples)), tree_(positions_), windings_(samples.size(), 0)
{
}

void WindingNumbers::vote(std::span<std::uint8_t> lies_in) const
{
    std::vector<int> balance(lies_in.size(), 0);
    for (std::size_t i = 0; i < samples_.size(); ++i) balance[samples_[i].candidate] += windings_[i] != 0 ? 1 : -1;
    for (std::size_t i = 0; i < lies_in.size(); ++i) lies_in[i] = balance[i] > 0;
}

}  // namespace kerf::core
