#pragma once

#include <memory>

#include "common/cutting/cut.h"

// The linear back end: one loop over all triangles, index tables instead of look-ups of vertices, right caps. The best
// choice for a few cuts of a mesh that is not prepared otherwise: prepare() costs next to nothing.

namespace kerf::core::linear {

/// Its objects are compact arrays that belong to nobody else. A cut is O(n).
std::unique_ptr<Backend> make_back_end();

}  // namespace kerf::core::linear
