#include "halfedge/universe/cut_reserve.h"

#include <cmath>

namespace kerf::core::halfedge {

namespace {

// What a cut adds for each crossing triangle. A crossing triangle has one crossed edge of its own.
constexpr std::size_t kPoints = 2;    // the cut point of its edge, once a side
constexpr std::size_t kEdges = 6;     // the other half of its edge, a diagonal, two section edges, and two of its caps
constexpr std::size_t kFaces = 4;     // two beside the one that it is already, and one cap triangle a side
constexpr std::size_t kVertices = 3;  // one for its edge, seldom two, and one of a cap a side
constexpr std::size_t kSlots = 16;    // leaves that the plane meets are written anew: an estimate
constexpr std::size_t kNodes = 2;     // new leaves and their parents: an estimate of the bound that a cut asks for
constexpr std::size_t kNodesInAnyCase = 64;  // the way up to the root

}  // namespace

std::size_t crossings_of_one_cut(std::size_t triangles)
{
    return 64 + static_cast<std::size_t>(4.0 * std::sqrt(static_cast<double>(triangles)));
}

void reserve(Universe& u, const UniverseSize& size, std::size_t crossings)
{
    u.mesh.start(
        {size.points + kPoints * crossings, size.edges + kEdges * crossings, size.triangles + kFaces * crossings});
    u.vertices.reserve(size.vertices + kVertices * crossings, size.vertices);
    for (Stream& stream : u.streams)
        stream.values.reserve((size.vertices + kVertices * crossings) * stream.width, size.vertices * stream.width);
    u.slots.reserve(size.triangles + kSlots * crossings, size.triangles);
    u.face_of_slot.reserve(size.triangles + kSlots * crossings, size.triangles);
    u.source_of_face.reserve(size.triangles + kFaces * crossings, size.triangles);
    u.stamp_of_face.reserve(size.triangles + kFaces * crossings, size.triangles);
}

void reserve_nodes(Universe& u, const UniverseSize& size, std::size_t crossings)
{
    u.tree.reserve(size.nodes + kNodes * crossings + kNodesInAnyCase, size.nodes);
}

}  // namespace kerf::core::halfedge
