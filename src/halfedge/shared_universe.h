#pragma once

#include "common/cutting/buffer_identity.h"
#include "common/cutting/cut.h"
#include "halfedge/cut/workspace_pool.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// What all objects that descend from one prepared mesh share: the universe that they lie in. Its lock guards it.
struct SharedUniverse
{
    const BufferIdentity identity;  ///< of the vertex and index buffer
    const CapQuality cap_quality;   ///< of all cuts, if not a better one is asked for
    Universe universe;

    explicit SharedUniverse(const BufferListener& listener, CapQuality quality = CapQuality::fast)
        : identity(listener), cap_quality(quality)
    {
    }
    /// A copy with a lock of its own. Call it with `other` locked.
    SharedUniverse(const SharedUniverse& other)
        : identity(other.identity), cap_quality(other.cap_quality), universe(other.universe)
    {
    }
    SharedUniverse& operator=(const SharedUniverse&) = delete;

private:
    WorkspacePoolUser pool_user_;
};

}  // namespace kerf::core::halfedge
