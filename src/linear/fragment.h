#pragma once

#include <vector>

#include "common/cutting/cut.h"
#include "common/mesh/indexed_mesh.h"

namespace kerf::core::linear {

/// A mesh or a part of one, as the baseline keeps it: compact arrays that belong to nobody else.
struct Fragment
{
    IndexedMesh mesh;
    /// The material that was added for caps, if one was.
    std::uint32_t cap_material = kDefaultCapMaterial;
    double noise = 0.0;  ///< plane_noise of the mesh that prepare() got; the same for all its fragments
    std::vector<std::uint32_t>
        fan_centres;                   ///< added by fans: rounded, so they may stick out by a unit in the last place
    std::vector<SectionLoop> section;  ///< outline of the last cut
    Box bounds;                        ///< smallest box around the vertices

    /// Gives back room of more than kSpare times the size in use. A cut makes room for all of the object on either
    /// side; a small piece is cheap to copy and must not hold on to the memory of the whole, a large one wastes little.
    void release_spare_room()
    {
        constexpr std::size_t kSpare = 4;
        if (mesh.vertices.capacity() > kSpare * mesh.vertices.size()) {
            mesh.vertices.shrink_to_fit();
            mesh.points.shrink_to_fit();
        }
        if (mesh.triangles.capacity() > kSpare * mesh.triangles.size()) {
            mesh.triangles.shrink_to_fit();
            mesh.sources.shrink_to_fit();
        }
    }
};

}  // namespace kerf::core::linear
