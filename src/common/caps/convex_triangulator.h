#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Closes one strictly convex loop by halving it repeatedly: no point meets more than 2 log2(k) triangles, and a line
/// crosses O(log k) of them. O(k).
std::unique_ptr<CapTriangulator> make_convex_triangulator();

}  // namespace kerf::core
