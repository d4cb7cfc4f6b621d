#pragma once

#include <memory>

#include "common/cutting/cut.h"

namespace kerf::core::halfedge {

/// The back end whose cut costs what the section costs: O(k log k + s log n) for k crossing triangles and s leaves of
/// the tree that the plane meets, instead of O(n). docs/halfedge.md explains how.
std::unique_ptr<Backend> make_back_end();

}  // namespace kerf::core::halfedge
