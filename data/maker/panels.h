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

}  // namespace kerf::maker
