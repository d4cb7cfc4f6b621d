#pragma once

#include <cstdint>
#include <span>

#include "viewer/render/gl_objects.h"

namespace kerf::render {

/// A buffer on the GPU that bytes are appended to. When it is full it moves into one of twice the size, copied on the
/// GPU.
class GrowingBuffer
{
public:
    /// Makes room for `capacity` bytes. @throws RenderError  the GPU has no memory left
    explicit GrowingBuffer(std::uint64_t capacity);

    /// Writes bytes at an offset. They must be bytes that no drawing command has read: the driver is told not to wait.
    /// Returns true when the buffer has moved, so that vertex arrays must name it anew.
    /// @throws RenderError  the GPU has no memory left; the buffer is unchanged
    bool write(std::uint64_t offset, std::span<const std::byte> bytes);

    GLuint id() const { return buffer_.id(); }
    std::uint64_t capacity() const { return capacity_; }
    std::uint64_t bytes_copied() const { return bytes_copied_; }  ///< by growth

private:
    GlBuffer buffer_;
    std::uint64_t capacity_ = 0;
    std::uint64_t used_ = 0;  ///< end of what was written
    std::uint64_t bytes_copied_ = 0;
};

}  // namespace kerf::render
