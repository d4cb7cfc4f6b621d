#pragma once

#include <string>

#include "maker/poly_mesh.h"

namespace kerf::maker {

/// How many triangles write_obj makes of the mesh: n - 2 for a facet of n corners.
int triangle_count(const PolyMesh& mesh);

/// The mesh as the text of an OBJ file of triangles with positions, texture coordinates and normals; equal lines are
/// written once. Positions are rounded to 1e-5 units before normals are taken from them, and every number is the
/// shortest text that reads back as the same float. Throws std::logic_error when a facet cannot be divided.
std::string obj_text(const PolyMesh& mesh, const std::string& name);

}  // namespace kerf::maker
