#include "tools/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace kerf::tools {

namespace {

constexpr double kFirst = 500.0, kNext = 100.0;  // ms: work that is done sooner needs no line; no eye reads faster

}  // namespace

ProgressLine::~ProgressLine()
{
    if (is_shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double share)
{
    waited_ms_ += since_last_.lap();
    if (waited_ms_ < (is_shown_ ? kNext : kFirst) || isatty(STDERR_FILENO) == 0) return;
    waited_ms_ = 0.0;
    is_shown_ = true;
    std::fprintf(stderr, "\r%s: %3.0f %%", what_.c_str(), 100.0 * share);
    std::fflush(stderr);
}

}  // namespace kerf::tools
