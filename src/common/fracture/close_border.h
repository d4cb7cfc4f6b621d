#pragma once

#include "common/cutting/breakable.h"

namespace kerf::core {

/// Pairs the half-edges of a border. False if they can't be paired, so that the piece has to be repaired, or if its new
/// triangles fall into parts. O(t) for t triangles.
bool close_border(PieceBorder& border);

}  // namespace kerf::core
