#pragma once

namespace kerf::test {

/// Whether this build has no long tests (KERF_BUILD_LONG_TESTS is off: sanitizers, other compilers). What is tried many
/// times is tried less often then; the default build and `./run soak-asan` do all of it.
#ifdef KERF_BRIEF_TESTS
inline constexpr bool kBrief = true;
#else
inline constexpr bool kBrief = false;
#endif

}  // namespace kerf::test

namespace kerf::core::test {
using namespace kerf::test;
}
