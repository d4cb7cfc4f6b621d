#pragma once

#include <string>

#include "common/support/stopwatch.h"

namespace kerf::tools {

/// A line on a terminal that says how far the work is. Nothing if the standard error is no terminal, or if the work is
/// done at once.
class ProgressLine
{
public:
    explicit ProgressLine(std::string what) : what_(std::move(what)) {}
    ~ProgressLine();  ///< takes the line away
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(double share);

private:
    std::string what_;
    core::Stopwatch since_last_;
    double waited_ms_ = 0.0;
    bool is_shown_ = false;
};

}  // namespace kerf::tools
