#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "common/fracture/fragments.h"
#include "common/fracture/sites.h"
#include "common/fracture/solid_of_points.h"

namespace kerf::core {

/// A solid in fragments, of which PieceMeshes makes meshes.
struct TakenApart
{
    std::vector<glm::dvec3> sites;  ///< of the cells; moved a little, if they lay badly
    SplitSolid split;
    Fragments fragments;
};

/// Takes a closed solid apart into the cells of sites: split_into_cells(), again and again with the sites moved a little as
/// long as it refuses, and find_fragments(). The same input gives the same bytes. Nothing if it refuses for good: the surface
/// passes through itself where cells meet.
///
/// @param least_volume  smaller fragments are joined to their neighbours; cubed units of the mesh
std::optional<TakenApart> take_apart(const SolidOfPoints& solid, std::span<const glm::dvec3> sites, double least_volume,
                                     const ProgressOfStep& progress = {});

/// Whether a solid can be split with these sites. It is told which share of the work its own is.
using SplitTrial = std::function<bool(std::span<const glm::dvec3> sites, const ProgressOfStep& progress)>;

/// Tries to split with sites, and again with these moved a little, as long as it fails: a solid in that box. Returns the sites
/// with which it did not, or none.
std::vector<glm::dvec3> sites_that_split(const Box& box, std::span<const glm::dvec3> sites, const SplitTrial& splits,
                                         const ProgressOfStep& progress = {});

/// What a fragment of a solid in that box has at least, or it is none: rounding has made it. Cubed units of the mesh.
double least_volume_of_fragment(const Box& box);

}  // namespace kerf::core
