#pragma once

#include <cstdint>

namespace kerf::game {

/// What the scene `giant` can be asked for.
inline constexpr std::int64_t kFewestGiantTriangles = 10'000, kMostGiantTriangles = 4'000'000;

}  // namespace kerf::game
