#include "common/cutting/statistics.h"

#include <numeric>

namespace kerf::core {

std::string_view name_of(Phase phase)
{
    switch (phase) {
        case Phase::find:
            return "find";
        case Phase::walk:
            return "walk";
        case Phase::split:
            return "split";
        case Phase::copy:
            return "copy";
        case Phase::cap:
            return "cap";
        case Phase::rebuild:
            return "rebuild";
        case Phase::components:
            return "components";
        case Phase::growth:
            return "growth";
    }
    return "unknown";
}

double PhaseTimes::total() const
{
    return std::accumulate(ms.begin(), ms.end(), 0.0);
}

}  // namespace kerf::core
