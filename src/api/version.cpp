#include <kerf/version.h>

#include "common/cutting/bits_version.h"

namespace kerf {

const char* version() noexcept
{
    return KERF_VERSION;
}

std::uint32_t bits_version() noexcept
{
    return core::bits_version();
}

}  // namespace kerf
