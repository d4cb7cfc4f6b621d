#pragma once

#include <cstddef>
#include <cstring>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace kerf::core {

/// Four floats: what every x86-64 and every 64-bit ARM computes in one step.
using Four = float __attribute__((vector_size(16)));
inline constexpr std::size_t kLanes = 4;

// Written so that each is one instruction. Lane by lane; if neither compares, `b`.
inline Four larger(Four a, Four b)
{
    return a > b ? a : b;
}
inline Four smaller(Four a, Four b)
{
    return a < b ? a : b;
}

/// In which lanes a comparison of two is true: bit i for lane i.
inline unsigned lanes_of(decltype(Four{} == Four{}) comparison)
{
#ifdef __SSE__
    return unsigned(_mm_movemask_ps(__m128(comparison)));
#else
    unsigned lanes = 0;
    for (std::size_t i = 0; i < kLanes; ++i) lanes |= unsigned{comparison[i] != 0} << i;
    return lanes;
#endif
}
/// In which lanes two are equal.
inline unsigned equal_lanes(Four a, Four b)
{
    return lanes_of(a == b);
}

inline Four load(const float* p)
{
    Four four;
    std::memcpy(&four, p, sizeof four);
    return four;
}
inline void store(float* p, const Four& four)
{
    std::memcpy(p, &four, sizeof four);
}

}  // namespace kerf::core
