#pragma once

#include "common/mesh/triangle_soup.h"
#include "maker/poly_mesh.h"

namespace kerf::maker {

/// The mesh as triangles with shared vertices: a vertex for each different point, normal and texture coordinate.
/// Numbers are rounded as obj_text() does, so that a file of them is the same whatever the C library's sine. Materials
/// have the colours of kFruitMaterials. Throws std::logic_error where one has none or a facet cannot be divided.
core::TriangleSoup soup_of(const PolyMesh& mesh);

}  // namespace kerf::maker
