#pragma once

#include <span>

#include "common/cutting/cut.h"
#include "common/proxy/collision_proxy.h"

namespace kerf::core::baseline {

/// The report's collision shape (section 3.2.4): every vertex added to the physics engine's hull shape, one by one, as
/// its program does. The shape computes its bounding box anew with each of them, so this is quadratic; it is here to be
/// compared with. The result is of the kind `points`; empty for no vertices. O(n^2).
CollisionProxy every_vertex(std::span<const Vertex> vertices);

/// The same of the vertices that an object uses.
CollisionProxy every_vertex(const Cuttable& object);

}  // namespace kerf::core::baseline
