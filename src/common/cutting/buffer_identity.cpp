#include "common/cutting/buffer_identity.h"

#include <atomic>

namespace kerf::core {

std::uint64_t new_buffers_serial() noexcept
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

}  // namespace kerf::core
