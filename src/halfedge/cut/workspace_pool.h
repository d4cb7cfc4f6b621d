#pragma once

#include <cstddef>
#include <memory>

#include "halfedge/cut/workspace.h"

// The memory that cuts are planned in goes from one cut to the next, whatever objects they cut: a new clone finds it warm.

namespace kerf::core::halfedge {

/// Keeps the pool: its memory is freed when the last one of these ends. Each universe has one.
class WorkspacePoolUser
{
public:
    WorkspacePoolUser() noexcept;
    ~WorkspacePoolUser();
    WorkspacePoolUser(const WorkspacePoolUser&) = delete;
    WorkspacePoolUser& operator=(const WorkspacePoolUser&) = delete;
};

/// A workspace for one cut at a time; the pool has as many as there were cuts at once. The one that was used last is
/// taken first. Any thread; O(1).
class BorrowedWorkspace
{
public:
    /// Throws std::bad_alloc.
    BorrowedWorkspace();
    ~BorrowedWorkspace();
    BorrowedWorkspace(const BorrowedWorkspace&) = delete;
    BorrowedWorkspace& operator=(const BorrowedWorkspace&) = delete;

    CutWorkspace& operator*() const { return *workspace_; }
    CutWorkspace* operator->() const { return workspace_.get(); }

private:
    std::unique_ptr<CutWorkspace> workspace_;
};

/// Makes room in the pool for one cut through the middle of an object of so many triangles, so that it need not wait for
/// memory. Throws std::bad_alloc.
void make_room_for_cut(std::size_t triangles);

}  // namespace kerf::core::halfedge
