#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "viewer/render/gl_objects.h"

namespace kerf::render {

/// How bytes get into a buffer.
enum class Mapping
{
    kept,        ///< the buffer stays mapped and a write is a copy: no call of the driver (ARB_buffer_storage)
    each_write,  ///< mapped for each write: every driver can, and may move the buffer to its fastest memory
};

/// Larger buffers are mapped for each write: a driver may keep what stays mapped in memory that draws slowly.
inline constexpr std::uint64_t kMostKeptMapped = 8u << 20;

/// What suits a buffer of so many bytes with the driver that is current.
Mapping mapping_for(std::uint64_t capacity);

/// A buffer on the GPU that bytes are appended to. When it is full it moves into one of twice the size, copied on the
/// GPU.
class GrowingBuffer
{
public:
    /// Makes room for `capacity` bytes. @throws RenderError  the GPU has no memory left
    explicit GrowingBuffer(std::uint64_t capacity) : GrowingBuffer(capacity, mapping_for(capacity)) {}
    GrowingBuffer(std::uint64_t capacity, Mapping mapping);

    /// Writes bytes at an offset. They must be bytes that no drawing command has read: the driver is told not to wait.
    /// Returns true when the buffer has moved, so that vertex arrays must name it anew.
    /// @throws RenderError  the GPU has no memory left; the buffer is unchanged
    bool write(std::uint64_t offset, std::span<const std::byte> bytes);

    GLuint id() const { return storage_.buffer.id(); }
    std::uint64_t capacity() const { return capacity_; }
    std::uint64_t bytes_copied() const { return bytes_copied_; }  ///< by growth

private:
    struct Storage
    {
        GlBuffer buffer;
        std::byte* place = nullptr;  ///< where it stays mapped
    };
    static Storage allocated(std::uint64_t capacity, Mapping mapping);

    void write_mapping(std::uint64_t offset, std::span<const std::byte> bytes);

    Storage storage_;
    std::uint64_t capacity_ = 0;
    std::uint64_t used_ = 0;  ///< end of what was written
    std::uint64_t bytes_copied_ = 0;
};

}  // namespace kerf::render
