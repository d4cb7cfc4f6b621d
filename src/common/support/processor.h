#pragma once

// Instructions that not every processor has, chosen while the program runs. Every variant gives the same bytes: the same
// operations in the same order, only more lanes at a time (docs/floating-point.md).

namespace kerf::core {

/// Whether this processor computes eight floats in one step (AVX2) and the code for it is here.
bool has_avx2() noexcept;

/// For tests: as long as one of these lives, has_avx2() says no, in every thread.
class WithoutAvx2
{
public:
    WithoutAvx2() noexcept;
    ~WithoutAvx2();
    WithoutAvx2(const WithoutAvx2&) = delete;
    WithoutAvx2& operator=(const WithoutAvx2&) = delete;
};

}  // namespace kerf::core

#if defined(__x86_64__)
/// A function that may use AVX2; call it only if has_avx2(). No fused multiply-add comes with it.
#define KERF_AVX2 __attribute__((target("avx2")))
#endif

/// A function that becomes a part of each one that calls it, and uses the instructions that its caller may.
#define KERF_IN_CALLER inline __attribute__((always_inline))
