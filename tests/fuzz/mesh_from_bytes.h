#pragma once

#include "common/mesh/plane.h"
#include "common/mesh/triangle_soup.h"
#include "fuzz/byte_reader.h"

namespace kerf::core::fuzz {

/// At most some two hundred triangles: a generated shape whose vertices are moved about, any triangles over a few
/// points, or an open mesh that touches itself. Coordinates are finite and indices in range; nothing else is promised.
/// With several materials, seams and a stream now and then.
TriangleSoup soup_from(ByteReader& bytes);

/// A plane that meets the mesh in an interesting way: through vertices, along edges, in faces, along the axes,
/// anywhere. Valid, but may miss.
Plane plane_from(ByteReader& bytes, const IndexedMesh& mesh);

/// No directed edge twice, and one fan around each point: what IndexedMesh promises about neighbours and check() does
/// not look at.
bool is_manifold(const IndexedMesh& mesh);

}  // namespace kerf::core::fuzz
