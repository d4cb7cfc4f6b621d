#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "halfedge/universe/numbering.h"

namespace kerf::core::halfedge {

/// The chunks of a numbering, one after another. Another thread may number them, ahead of who takes them.
class NumberedChunks
{
public:
    /// @param on_another_thread  what is asked for; if there is no thread to be had, each chunk is numbered when it is
    ///                           taken
    /// @throws std::bad_alloc
    NumberedChunks(Numbering& numbering, bool on_another_thread);
    /// Ends the thread, also if not all chunks were taken.
    ~NumberedChunks();
    NumberedChunks(const NumberedChunks&) = delete;
    NumberedChunks& operator=(const NumberedChunks&) = delete;

    NumberedChunk next();

private:
    void number_ahead();

    Numbering& numbering_;
    std::vector<NumberedChunk> chunks_;  ///< of the other thread
    std::size_t taken_ = 0;
    std::atomic<std::size_t> numbered_{0};
    std::atomic<bool> is_to_end_{false};
    std::thread thread_;
};

}  // namespace kerf::core::halfedge
