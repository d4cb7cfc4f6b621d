#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "maker/poly_mesh.h"

namespace kerf::maker {

/// Sinks (depth > 0) or raises (depth < 0) a connected region of facets, a disc: its outline moves inwards by `margin`,
/// which leaves a frame of the old material, and then by `depth` against the normal; what it encloses becomes
/// `material`. Two quads more for each edge of the outline, one where `margin` is 0. O(facets).
void inset(PolyMesh& mesh, const std::vector<std::size_t>& region, double margin, double depth,
           std::string_view material);

struct BossLayer
{
    double scale;   ///< of the outline about its middle, against the first
    double height;  ///< over the facet
};

/// Builds a small thing on a four-cornered facet: its foot is the part s0..s1 by t0..t1 of the facet (s from the edge
/// between corners 0 and 1 to that between 3 and 2, t along these), its layers follow upwards, a flat top ends it.
/// 6 triangles more, 8 for each layer and 2 for the top.
void boss(PolyMesh& mesh, std::size_t facet, const std::array<double, 4>& s0_s1_t0_t1,
          const std::vector<BossLayer>& layers, std::string_view material);

/// Divides each four-cornered facet whose halves' normals differ by more than `degrees` into two facets, so that the
/// fold is seen. The number of triangles stays.
void fold_bent_facets(PolyMesh& mesh, double degrees);

/// Joins triangles in pairs, flattest pairs first, while their normals differ by at most `degrees`: each pair is shaded
/// as one facet. Only pairs that make a convex four-sided facet of one material. O(n log n).
void pair_triangles(PolyMesh& mesh, double degrees);

/// Points shared by both sides lie at x = 0 exactly; all others get a mirror image, and so does every facet.
/// Facet f's image is facet f + (number of facets before).
void mirror_x(PolyMesh& mesh);

}  // namespace kerf::maker
