#pragma once

#include <ctime>

namespace kerf::core {

/// Time that the calling thread has spent on a processor, its page faults included, in seconds since construction or
/// the last lap. The timed work runs in one thread and waits for nothing; on a shared machine wall-clock time would
/// measure the neighbours.
class CpuStopwatch
{
public:
    CpuStopwatch() { lap(); }

    /// Seconds since the last lap, which begins anew.
    double lap()
    {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        const double seconds = double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
        const double elapsed = seconds - start_;
        start_ = seconds;
        return elapsed;
    }

private:
    double start_ = 0.0;
};

}  // namespace kerf::core
