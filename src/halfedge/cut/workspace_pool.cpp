#include "halfedge/cut/workspace_pool.h"

#include <array>
#include <cstddef>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "halfedge/universe/cut_reserve.h"

namespace kerf::core::halfedge {

namespace {

/// The program's workspaces.
class Pool
{
public:
    void begin_use() noexcept
    {
        const std::lock_guard lock(mutex_);
        ++users_;
    }

    void end_use() noexcept
    {
        std::vector<std::unique_ptr<CutWorkspace>> unused;  // ends after the lock
        const std::lock_guard lock(mutex_);
        if (--users_ > 0) return;
        unused.swap(free_);
        made_ = 0;
    }

    std::unique_ptr<CutWorkspace> take()
    {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                std::unique_ptr<CutWorkspace> last = std::move(free_.back());
                free_.pop_back();
                return last;
            }
            free_.reserve(made_ + 1);  // so that none is lost on its way back
            ++made_;
        }
        try {
            return std::make_unique<CutWorkspace>();
        } catch (...) {
            const std::lock_guard lock(mutex_);
            --made_;
            throw;
        }
    }

    void give_back(std::unique_ptr<CutWorkspace> workspace) noexcept
    {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(workspace));
    }

private:
    std::mutex mutex_;
    std::size_t users_ = 0;
    std::size_t made_ = 0;  ///< free ones and borrowed ones
    std::vector<std::unique_ptr<CutWorkspace>> free_;
};

Pool& pool()
{
    // It never ends: threads that nobody waits for may let go of objects while the program ends. It holds nothing then.
    alignas(Pool) static std::array<std::byte, sizeof(Pool)> room;
    static Pool* const program = new (room.data()) Pool;
    return *program;
}

}  // namespace

WorkspacePoolUser::WorkspacePoolUser() noexcept
{
    pool().begin_use();
}

WorkspacePoolUser::~WorkspacePoolUser()
{
    pool().end_use();
}

BorrowedWorkspace::BorrowedWorkspace() : workspace_(pool().take()) {}

BorrowedWorkspace::~BorrowedWorkspace()
{
    pool().give_back(std::move(workspace_));
}

void make_room_for_cut(std::size_t triangles)
{
    BorrowedWorkspace()->reserve(crossings_of_one_cut(triangles));
}

}  // namespace kerf::core::halfedge
