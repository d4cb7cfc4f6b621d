#pragma once

#include <chrono>

namespace kerf::core {

/// Wall-clock time in milliseconds since construction or the last lap().
class Stopwatch
{
public:
    /// Milliseconds since the last lap, which begins anew.
    double lap()
    {
        const auto now = std::chrono::steady_clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - start_).count();
        start_ = now;
        return ms;
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace kerf::core
