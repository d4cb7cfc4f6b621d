#pragma once

#include "common/cutting/buffer_identity.h"
#include "halfedge/cut/workspace_pool.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// What all objects that descend from one prepared mesh share: the universe that they lie in. Its lock guards it.
struct SharedUniverse
{
    const BufferIdentity identity;  ///< of the vertex and index buffer
    Universe universe;

    explicit SharedUniverse(const BufferListener& listener = {}) : identity(listener) {}
    /// A copy with a lock of its own. Call it with `other` locked.
    SharedUniverse(const SharedUniverse& other) : identity(other.identity), universe(other.universe) {}
    SharedUniverse& operator=(const SharedUniverse&) = delete;

private:
    WorkspacePoolUser pool_user_;
};

}  // namespace kerf::core::halfedge
