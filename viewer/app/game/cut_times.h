#pragma once

#include <deque>
#include <string>
#include <vector>

#include "viewer/app/frame_statistics.h"
#include "viewer/sim/cut_log.h"

namespace kerf::app {

/// What cuts took, from hit to pieces: a series for each back end, so that one can compare them after a switch.
class CutTimes
{
public:
    struct Series
    {
        std::string backend;
        FrameStatistics times;
    };

    /// Takes in what was added to the log since the last call.
    void follow(const std::vector<sim::CutRecord>& log);

    /// In the order in which back ends first cut; what went through nothing is left out.
    const std::deque<Series>& series() const { return series_; }
    /// Null: it has cut nothing yet.
    const Series* of(const std::string& backend) const;
    /// The longest cut that any series still holds, milliseconds; 0: none.
    double most() const;

private:
    std::deque<Series> series_;
    std::size_t seen_ = 0;
};

}  // namespace kerf::app
