#include "common/support/processor.h"

#include <atomic>

namespace kerf::core {

namespace {

std::atomic<int> refusals = 0;

}  // namespace

bool has_avx2() noexcept
{
#ifdef KERF_AVX2
    static const bool has = [] {
        __builtin_cpu_init();
        return __builtin_cpu_supports("avx2") != 0;
    }();
    return has && refusals.load(std::memory_order_relaxed) == 0;
#else
    return false;
#endif
}

WithoutAvx2::WithoutAvx2() noexcept
{
    ++refusals;
}

WithoutAvx2::~WithoutAvx2()
{
    --refusals;
}

}  // namespace kerf::core
