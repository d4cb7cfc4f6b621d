#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace kerf::app {

/// Times in milliseconds, and what one wants to know of them.
struct TimeSummary
{
    std::size_t count = 0;
    double least = 0.0, median = 0.0, mean = 0.0, p99 = 0.0, most = 0.0;
};

/// All zero for no times. O(n)
TimeSummary summary_of(std::vector<double> times_ms);

/// The last frames' times, for the panel: a plot, its extremes, and the worst frame since the last reset.
class FrameStatistics
{
public:
    static constexpr std::size_t kShown = 240;  ///< four seconds at 60 Hz

    void add(double frame_ms);
    void reset_worst() { worst_ms_ = 0.0; }

    double least() const;
    double most() const;
    double mean() const;
    double last() const;
    double worst_since_reset() const { return worst_ms_; }
    std::size_t size() const { return count_ < kShown ? count_ : kShown; }

    /// For a plot: kShown values, of which the oldest is at offset().
    const float* values() const { return times_.data(); }
    std::size_t offset() const { return count_ % kShown; }

private:
    std::array<float, kShown> times_{};
    std::size_t count_ = 0;
    double worst_ms_ = 0.0;
};

}  // namespace kerf::app
