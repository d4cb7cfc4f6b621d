#pragma once
#include <cstddef>
#include <span>

namespace kerf::bench {

struct CutCost
{
    double crossing = 0.0;  ///< triangles
    double seconds = 0.0;
};

struct WorstCut
{
    double to_predicted = 0.0;  ///< how many times more it costs than predicted
    std::size_t number = 0;
};

/// The cut that costs most compared with what the line through all of them predicts from its crossing triangles. The line
/// is that of Theil and Sen, which a few bad cuts don't bend: the median of the slopes between all pairs, then the median
/// of what is left. O(n^2) in the number of cuts.
WorstCut worst_to_predicted(std::span<const CutCost> cuts);

}  // namespace kerf::bench
