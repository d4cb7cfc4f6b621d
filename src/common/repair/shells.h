#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "common/mesh/box.h"
#include "common/repair/linked_surface.h"
#include "common/repair/vertex_fans.h"

namespace kerf::core {

/// A part of a surface that is connected by edges.
struct ConnectedShell
{
    Box box;
    bool closed = true;    ///< no boundary
    double volume6 = 0.0;  ///< 6 times the signed volume; of an open shell: see kLargestHole
    std::uint32_t triangle_count = 0;
    glm::vec3 apex{0.0f};  ///< one of its corners: the apex of the tetrahedra that add up to the volume
};

/// The shells of a surface, in the order of their first triangles.
struct Shells
{
    Buffer<std::uint32_t> shell;  ///< for each triangle
    std::vector<ConnectedShell> shells;
    double shortest_edge =
        std::numeric_limits<double>::infinity();  ///< of all, in mesh units, except those of length 0

    bool closed() const
    {
        return std::all_of(shells.begin(), shells.end(), [](const ConnectedShell& one) { return one.closed; });
    }
    Box box() const
    {
        Box box;
        for (const ConnectedShell& one : shells) box.add(one.box);
        return box;
    }
};

/// A closed shell has an inside, and so has an open one whose holes are small (kLargestHole). Shells without an inside
/// get volume 0. O(n).
Shells find_shells(const LinkedSurface& surface, const VertexFans& fans, std::span<const glm::vec3> positions);

}  // namespace kerf::core
