#include "bench/back_ends.h"

#include "back_ends/back_ends.h"
#include "baseline/report_back_ends.h"

namespace kerf::bench {

const std::vector<TimedBackend>& back_ends()
{
    constexpr std::uint64_t kQuadraticLimit = 30'000, kNoLimit = UINT64_MAX;
    static const std::vector<TimedBackend> all = [] {
        std::vector<TimedBackend> timed;
        add_report_back_ends();
        for (const RegisteredBackend* entry : core::back_ends())
            timed.insert(timed.begin(), {entry->make(), entry->is_quadratic ? kQuadraticLimit : kNoLimit});
        return timed;
    }();
    return all;
}

}  // namespace kerf::bench
