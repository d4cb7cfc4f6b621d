#pragma once

#include "common/cutting/buffer_identity.h"
#include "halfedge/cut/workspace.h"
#include "halfedge/universe/cut_reserve.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// What all objects that descend from one prepared mesh share: the universe that they lie in, and the memory that cuts
/// of any of them are planned in. Both are guarded by the universe's lock.
struct SharedUniverse
{
    const BufferIdentity identity;  ///< of the vertex and index buffer
    Universe universe;
    CutWorkspace workspace;

    explicit SharedUniverse(const BufferListener& listener = {}) : identity(listener) {}
    /// A copy with a lock of its own. Call it with `other` locked.
    SharedUniverse(const SharedUniverse& other) : identity(other.identity), universe(other.universe)
    {
        universe.stamp_base += other.workspace.stamps_used();  // the copied faces keep their stamps
        make_room(other.universe.slots.size());
    }
    SharedUniverse& operator=(const SharedUniverse&) = delete;

    /// For planning one cut of an object of so many triangles.
    void make_room(std::size_t triangles) { workspace.reserve(crossings_of_one_cut(triangles)); }
};

}  // namespace kerf::core::halfedge
