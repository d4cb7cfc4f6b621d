#include "bench/predicted_cost.h"

#include <utility>
#include <vector>

#include "common/support/median.h"

namespace kerf::bench {

WorstCut worst_to_predicted(std::span<const CutCost> cuts)
{
    std::vector<double> slopes, rests;
    for (std::size_t i = 0; i < cuts.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (cuts[i].crossing != cuts[j].crossing)
                slopes.push_back((cuts[i].seconds - cuts[j].seconds) / (cuts[i].crossing - cuts[j].crossing));
    const double slope = slopes.empty() ? 0.0 : core::median(std::move(slopes));
    for (const CutCost& cut : cuts) rests.push_back(cut.seconds - slope * cut.crossing);
    const double rest = core::median(std::move(rests));
    WorstCut worst;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const double share = cuts[i].seconds / (rest + slope * cuts[i].crossing);
        if (share > worst.to_predicted) worst = {share, i};
    }
    return worst;
}

}  // namespace kerf::bench
