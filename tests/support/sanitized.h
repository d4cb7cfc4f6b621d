#pragma once

namespace kerf::test {

/// Whether this program was built with the address sanitizer: what takes long takes ten times as long, and memory is
/// the sanitizer's, too. GCC says so by a macro, clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kAddressSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kAddressSanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool kAddressSanitized = false;
#endif

}  // namespace kerf::test

namespace kerf::core::test {
using namespace kerf::test;
}
