#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace kerf::tools {

/// The most threads that can be asked for.
inline constexpr unsigned kMostThreads = 1024;

/// As many as were asked for; of 0 as many as the processor has.
inline unsigned thread_count(unsigned asked)
{
    return asked > 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

/// Calls `work(i)` for each i below `count`, on several threads, and `take(i, result)` with what each has returned: one
/// after the other, in order, on the caller's thread. No more than a few results wait, because they may be large. What
/// `work` throws is thrown where its result would be taken; then, or if `take` throws, what has not begun is left out.
template <class Work, class Take>
void in_order(std::size_t count, unsigned threads, Work work, Take take)
{
    using Result = decltype(work(std::size_t(0)));
    struct Slot
    {
        std::optional<Result> result;
        std::exception_ptr failure;
        bool is_done = false;
    };
    std::vector<Slot> slots(count);
    std::mutex mutex;
    std::condition_variable something_changed;
    std::size_t next = 0, taken = 0;
    bool is_stopped = false;
    const std::size_t ahead = 2 * std::size_t(threads);

    const auto run = [&] {
        for (std::unique_lock lock(mutex);;) {
            something_changed.wait(lock, [&] { return is_stopped || next >= count || next < taken + ahead; });
            if (is_stopped || next >= count) return;
            const std::size_t i = next++;
            lock.unlock();
            Slot slot;
            try {
                slot.result.emplace(work(i));
            } catch (...) {
                slot.failure = std::current_exception();
            }
            slot.is_done = true;
            lock.lock();
            slots[i] = std::move(slot);
            something_changed.notify_all();
        }
    };
    struct Workers
    {
        std::vector<std::thread> all;
        std::mutex& mutex;
        std::condition_variable& something_changed;
        bool& is_stopped;
        ~Workers()
        {
            {
                const std::lock_guard lock(mutex);
                is_stopped = true;
            }
            something_changed.notify_all();
            for (std::thread& thread : all) thread.join();
        }
    } workers{{}, mutex, something_changed, is_stopped};
    for (unsigned i = 0; i < threads && i < count; ++i) workers.all.emplace_back(run);

    for (std::size_t i = 0; i < count; ++i) {
        Slot slot;
        {
            std::unique_lock lock(mutex);
            something_changed.wait(lock, [&] { return slots[i].is_done; });
            slot = std::exchange(slots[i], Slot());
            taken = i + 1;
        }
        something_changed.notify_all();
        if (slot.failure) std::rethrow_exception(slot.failure);
        take(i, *std::move(slot.result));
    }
}

}  // namespace kerf::tools
