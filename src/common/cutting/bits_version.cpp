#include "common/cutting/bits_version.h"

namespace kerf::core {

std::uint32_t bits_version() noexcept
{
    return 2;
}

}  // namespace kerf::core
