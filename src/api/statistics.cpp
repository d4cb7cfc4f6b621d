#include <kerf/statistics.h>

#include "common/cutting/statistics.h"

namespace kerf {

static_assert(kPhaseCount == core::kPhaseCount);
static_assert(int(Phase::find) == int(core::Phase::find) && int(Phase::walk) == int(core::Phase::walk) &&
              int(Phase::split) == int(core::Phase::split) && int(Phase::copy) == int(core::Phase::copy) &&
              int(Phase::cap) == int(core::Phase::cap) && int(Phase::rebuild) == int(core::Phase::rebuild) &&
              int(Phase::components) == int(core::Phase::components) && int(Phase::growth) == int(core::Phase::growth));

const char* text(Phase phase) noexcept
{
    return core::name_of(static_cast<core::Phase>(phase)).data();
}

}  // namespace kerf
