#include "viewer/app/game/cut_times.h"

#include <algorithm>

namespace kerf::app {

void CutTimes::follow(const std::vector<sim::CutRecord>& log)
{
    for (; seen_ < log.size(); ++seen_) {
        const sim::CutRecord& cut = log[seen_];
        if (cut.pieces.empty()) continue;
        auto found = std::find_if(series_.begin(), series_.end(),
                                  [&](const Series& series) { return series.backend == cut.backend; });
        if (found == series_.end()) found = series_.insert(series_.end(), Series{cut.backend, {}});
        found->times.add(cut.cut_ms + cut.proxy_ms + cut.bodies_ms);
    }
}

const CutTimes::Series* CutTimes::of(const std::string& backend) const
{
    const auto found =
        std::find_if(series_.begin(), series_.end(), [&](const Series& series) { return series.backend == backend; });
    return found == series_.end() ? nullptr : &*found;
}

double CutTimes::most() const
{
    double most = 0.0;
    for (const Series& series : series_) most = std::max(most, series.times.most());
    return most;
}

}  // namespace kerf::app
