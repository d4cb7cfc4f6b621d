#pragma once

#include <mutex>
#include <shared_mutex>

namespace kerf::core::halfedge {

/// A std::shared_mutex (many readers or one writer) that takes turns: readers that come after a waiting writer wait for
/// it, so that a stream of them cannot hold it up for ever. (glibc's lock lets readers pass.) Works with
/// std::unique_lock and std::shared_lock. A thread that reads must not lock again.
class FairSharedMutex
{
public:
    void lock()
    {
        const std::lock_guard turn(turn_);
        mutex_.lock();
    }
    void unlock() { mutex_.unlock(); }

    void lock_shared()
    {
        const std::lock_guard turn(turn_);
        mutex_.lock_shared();
    }
    void unlock_shared() { mutex_.unlock_shared(); }

private:
    std::mutex turn_;  ///< a waiting writer holds it
    std::shared_mutex mutex_;
};

}  // namespace kerf::core::halfedge
