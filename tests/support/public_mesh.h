#pragma once

#include <kerf/mesh.h>

#include "common/mesh/triangle_soup.h"

namespace kerf::test {

/// The mesh that a program makes of these triangles. @throws std::runtime_error  it is none
Mesh mesh_of(const core::TriangleSoup& soup, MeshReport* report = nullptr);

}  // namespace kerf::test
