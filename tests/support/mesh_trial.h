#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "common/cutting/cut.h"
#include "support/fixtures.h"

// Any mesh at all through prepare(), cut() and all queries of every back end.

namespace kerf::core::test {

/// What became of a mesh.
struct MeshTrial
{
    std::string refusal;  ///< why it was refused; empty when it was cut
    std::uint32_t cuts = 0, missed = 0;
    std::uint32_t closed = 0;         ///< cuts of something closed, all pieces of which are closed
    std::uint32_t pieces = 0;         ///< of all back ends
    std::uint32_t proven_pieces = 0;  ///< those that prove() takes again
};

/// Hands a mesh to all back ends and cuts it a few times, with all queries of what comes out.
///
/// @throws std::logic_error  a promise is broken: the back ends don't agree on whether the mesh can be cut, or with a
///                           referee; what was closed is not; a query names what is not there; sides differ ...
MeshTrial try_mesh(const IndexedMesh& mesh, std::span<const std::unique_ptr<Backend>> backends, Random& random);

}  // namespace kerf::core::test
