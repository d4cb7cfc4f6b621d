#include "viewer/render/growing_buffer.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "viewer/render/render_error.h"

namespace kerf::render {

namespace {

/// The target through which buffers are filled: binding it disturbs no vertex array.
constexpr GLenum kTarget = GL_COPY_WRITE_BUFFER;

GlBuffer allocated(std::uint64_t size)
{
    GlBuffer buffer = GlBuffer::create();
    glBindBuffer(kTarget, buffer.id());
    glBufferData(kTarget, static_cast<GLsizeiptr>(size), nullptr, GL_STATIC_DRAW);
    GLint64 got = 0;
    glGetBufferParameteri64v(kTarget, GL_BUFFER_SIZE, &got);
    if (static_cast<std::uint64_t>(got) != size)
        throw RenderError("the graphics card has no room for " + std::to_string(size) + " bytes");
    return buffer;
}

}  // namespace

// A buffer of no bytes cannot be mapped or copied.
GrowingBuffer::GrowingBuffer(std::uint64_t capacity) : capacity_(std::max<std::uint64_t>(capacity, 1))
{
    buffer_ = allocated(capacity_);
}

bool GrowingBuffer::write(std::uint64_t offset, std::span<const std::byte> bytes)
{
    if (bytes.empty()) return false;
    const std::uint64_t end = offset + bytes.size();
    const bool must_grow = end > capacity_;
    if (must_grow) {
        const std::uint64_t capacity = std::max(end, 2 * capacity_);
        GlBuffer larger = allocated(capacity);
        glBindBuffer(GL_COPY_READ_BUFFER, buffer_.id());
        if (used_ != 0) glCopyBufferSubData(GL_COPY_READ_BUFFER, kTarget, 0, 0, static_cast<GLsizeiptr>(used_));
        glBindBuffer(GL_COPY_READ_BUFFER, 0);
        bytes_copied_ += used_;
        buffer_ = std::move(larger);
        capacity_ = capacity;
    }
    glBindBuffer(kTarget, buffer_.id());
    // Nothing drawn so far reads these bytes, so there is nothing to wait for.
    void* const place = glMapBufferRange(kTarget, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                                         GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_UNSYNCHRONIZED_BIT);
    bool is_written = false;
    if (place != nullptr) {
        std::memcpy(place, bytes.data(), bytes.size());
        is_written = glUnmapBuffer(kTarget) == GL_TRUE;
    }
    // A driver may refuse to map, or lose what was mapped (a change of screen mode): the slow way always works.
    if (!is_written)
        glBufferSubData(kTarget, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    glBindBuffer(kTarget, 0);
    used_ = std::max(used_, end);
    return must_grow;
}

}  // namespace kerf::render
