#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Closes any outline: each loop is halved by its order alone, wherever its points lie. Triangles may overlap and be
/// turned over, but the cap is closed and its signed area is right. The last resort for self-intersecting input. O(k).
std::unique_ptr<CapTriangulator> make_topological_triangulator();

}  // namespace kerf::core
