#pragma once

#include <vector>

#include "maker/poly_mesh.h"

namespace kerf::maker {

/// Divides each four-cornered facet whose halves' normals differ by more than `degrees` into two facets, so that the
/// fold is seen. The number of triangles stays.
void fold_bent_facets(PolyMesh& mesh, double degrees);

/// Joins triangles in pairs, flattest pairs first, while their normals differ by at most `degrees`: each pair is shaded
/// as one facet. Only pairs that make a convex four-sided facet of one material. O(n log n).
void pair_triangles(PolyMesh& mesh, double degrees);

/// Points shared by both sides lie at x = 0 exactly; all others get a mirror image, and so does every facet.
/// Facet f's image is facet f + (number of facets before). Returns the image of each point.
std::vector<int> mirror_x(PolyMesh& mesh);

}  // namespace kerf::maker
