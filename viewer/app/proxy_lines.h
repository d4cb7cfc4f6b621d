#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "viewer/sim/body_proxies.h"

namespace kerf::app {

/// Adds the edges of a collision proxy as pairs of points, in the space that `model` maps mesh coordinates to. A hull
/// without faces gives a small cross at each of its points.
void append_proxy_lines(const sim::CollisionProxy& proxy, const glm::mat4& model, std::vector<glm::vec3>& lines);

}  // namespace kerf::app
