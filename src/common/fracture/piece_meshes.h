#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "common/cutting/breakable.h"
#include "common/fracture/fragments.h"
#include "common/repair/proven_mesh.h"

namespace kerf::core {

/// How the inside of a solid looks where it was taken apart.
struct InsideLook
{
    std::uint32_t material = 0;  ///< of the mesh
    double uv_scale = 1.0;       ///< uv for each mesh unit
};

/// Makes meshes of fragments, one after the other. They have the materials and streams of the mesh that was taken apart, and
/// the sources of its triangles.
///
/// Surface vertices are those of the mesh; new ones lie between them, with what lies between the attributes of the corners
/// of their triangle. Contacts are caps. Their uv are two coordinates in space, those across the axis that their plane is
/// most square to: so they run on from one contact to the next where both have the same axis, and from a piece to its
/// neighbour in any case. Their streams are those of the surface where they meet it, and the mean of the mesh inside.
class PieceMeshes
{
public:
    /// All arguments live as long as this. O(n).
    ///
    /// @param stream_means  of each stream of the object's vertices, if the mesh is only the border of it
    PieceMeshes(const IndexedMesh& mesh, std::span<const glm::vec3> points, const SplitSolid& split,
                const InsideLook& look, std::span<const std::vector<double>> stream_means = {});
    ~PieceMeshes();

    /// What closes a cell of a Breakable of which the mesh is the border, if that hangs together and nothing of it has to be
    /// repaired: each edge has two triangles, and those around a new point form one fan. O(t) for t triangles of it in the
    /// border.
    std::optional<PieceBorder> border_of(std::uint32_t cell);

    /// Nothing if no triangle has three different corners: a flake without a volume. O(t) for t triangles of it, and
    /// O(t log t) if points of it were rounded to one place.
    std::optional<ProvenMesh> make(const Fragment& fragment);

private:
    class Maker;
    std::unique_ptr<Maker> maker_;
};

}  // namespace kerf::core
