#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/cutting/breakable.h"
#include "common/fracture/piece_meshes.h"
#include "common/fracture/take_apart.h"

namespace kerf::core {

/// An object in fragments, of which some are objects already.
struct TakenApartBySubtrees
{
    TakenApart apart;
    /// For each fragment its object; null where PieceMeshes is to make a mesh of it.
    std::vector<std::unique_ptr<Cuttable>> objects;
    std::vector<glm::vec3> points;                  ///< of the border, for PieceMeshes
    std::vector<std::vector<double>> stream_means;  ///< for PieceMeshes
};

/// The same as take_apart() for an object with a tree: parts of it that lie in one cell are not looked at. A cell gets its
/// part as it is if it is one piece for sure (PieceMeshes::border_of()); the others are shown, and are fragments to make
/// meshes of, as those of take_apart() are. The pieces have the same surfaces in any case.
///
/// O(c log(n / c) + c log c) for c triangles of leaves at borders, and the triangles of the cells that are shown. Nothing if it
/// refuses for good: then take_apart() has to say so.
///
/// @param look  its material is one of the border's
std::optional<TakenApartBySubtrees> take_apart_by_subtrees(Breakable& object, std::span<const glm::dvec3> sites,
                                                           double least_volume, const InsideLook& look,
                                                           const ProgressOfStep& progress = {});

}  // namespace kerf::core
