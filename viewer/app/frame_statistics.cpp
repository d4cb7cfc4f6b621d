#include "viewer/app/frame_statistics.h"

#include <algorithm>
#include <numeric>

namespace kerf::app {

TimeSummary summary_of(std::vector<double> times)
{
    if (times.empty()) return {};
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) { return times[static_cast<std::size_t>(share * double(times.size() - 1))]; };
    const double sum = std::accumulate(times.begin(), times.end(), 0.0);
    return {times.size(), times.front(), at(0.5), sum / double(times.size()), at(0.99), times.back()};
}

void FrameStatistics::add(double frame_ms)
{
    times_[count_ % kShown] = static_cast<float>(frame_ms);
    ++count_;
    worst_ms_ = std::max(worst_ms_, frame_ms);
}

double FrameStatistics::least() const
{
    return size() == 0 ? 0.0 : double(*std::min_element(times_.begin(), times_.begin() + std::ptrdiff_t(size())));
}

double FrameStatistics::most() const
{
    return size() == 0 ? 0.0 : double(*std::max_element(times_.begin(), times_.begin() + std::ptrdiff_t(size())));
}

double FrameStatistics::mean() const
{
    if (size() == 0) return 0.0;
    return double(std::accumulate(times_.begin(), times_.begin() + std::ptrdiff_t(size()), 0.0f)) / double(size());
}

double FrameStatistics::last() const
{
    return count_ == 0 ? 0.0 : double(times_[(count_ - 1) % kShown]);
}

}  // namespace kerf::app
