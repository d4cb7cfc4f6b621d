#include "halfedge/universe/numbered_chunks.h"

#include <system_error>

namespace kerf::core::halfedge {

NumberedChunks::NumberedChunks(Numbering& numbering, bool on_another_thread) : numbering_(numbering)
{
    if (!on_another_thread) return;
    chunks_.resize(numbering.chunks());
    try {
        thread_ = std::thread([this] { number_ahead(); });
    } catch (const std::system_error&) {
        // Then without.
    }
}

NumberedChunks::~NumberedChunks()
{
    if (!thread_.joinable()) return;
    is_to_end_.store(true, std::memory_order_relaxed);
    thread_.join();
}

NumberedChunk NumberedChunks::next()
{
    if (!thread_.joinable()) return numbering_.next();
    for (std::size_t numbered; (numbered = numbered_.load(std::memory_order_acquire)) <= taken_;)
        numbered_.wait(numbered, std::memory_order_acquire);
    return chunks_[taken_++];
}

void NumberedChunks::number_ahead()
{
    for (std::size_t i = 0; i < chunks_.size() && !is_to_end_.load(std::memory_order_relaxed); ++i) {
        chunks_[i] = numbering_.next();
        numbered_.store(i + 1, std::memory_order_release);
        numbered_.notify_one();
    }
}

}  // namespace kerf::core::halfedge
