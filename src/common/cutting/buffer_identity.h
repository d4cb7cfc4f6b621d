#pragma once

#include <cstdint>

namespace kerf::core {

/// Told when buffers end, so that copies of them, on the GPU for example, can end, too.
struct BufferListener
{
    /// Called once, from the thread that ends the last object with these buffers. May be null.
    void (*released)(void* user, std::uint64_t buffers) = nullptr;
    void* user = nullptr;
};

/// A serial number for buffers, which no others get. From any thread.
std::uint64_t new_buffers_serial() noexcept;

/// What tells buffers from all others, as long as they live: a serial number, and who is told when they end. Copied
/// buffers are others: a copy has a number of its own, and the same listener.
class BufferIdentity
{
public:
    explicit BufferIdentity(const BufferListener& listener = {}) noexcept
        : serial_(new_buffers_serial()), listener_(listener)
    {
    }
    BufferIdentity(const BufferIdentity& other) noexcept : BufferIdentity(other.listener_) {}
    BufferIdentity& operator=(const BufferIdentity&) = delete;
    ~BufferIdentity()
    {
        if (listener_.released != nullptr) listener_.released(listener_.user, serial_);
    }

    std::uint64_t serial() const noexcept { return serial_; }
    const BufferListener& listener() const noexcept { return listener_; }

private:
    const std::uint64_t serial_;
    const BufferListener listener_;
};

}  // namespace kerf::core
