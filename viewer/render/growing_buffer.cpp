#include "viewer/render/growing_buffer.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "viewer/render/render_error.h"

namespace kerf::render {

namespace {

/// The target through which buffers are filled: binding it disturbs no vertex array.
constexpr GLenum kTarget = GL_COPY_WRITE_BUFFER;

/// Written bytes are seen by what is drawn afterwards, without a call in between.
constexpr GLbitfield kKept = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;

}  // namespace

Mapping mapping_for(std::uint64_t capacity)
{
    const bool is_offered = epoxy_gl_version() >= 44 || epoxy_has_gl_extension("GL_ARB_buffer_storage");
    return is_offered && capacity <= kMostKeptMapped ? Mapping::kept : Mapping::each_write;
}

GrowingBuffer::Storage GrowingBuffer::allocated(std::uint64_t capacity, Mapping mapping)
{
    Storage storage{GlBuffer::create(), nullptr};
    const auto size = static_cast<GLsizeiptr>(capacity);
    glBindBuffer(kTarget, storage.buffer.id());
    if (mapping == Mapping::kept)
        glBufferStorage(kTarget, size, nullptr, kKept | GL_DYNAMIC_STORAGE_BIT);
    else
        glBufferData(kTarget, size, nullptr, GL_STATIC_DRAW);
    GLint64 got = 0;
    glGetBufferParameteri64v(kTarget, GL_BUFFER_SIZE, &got);
    if (got != GLint64(size))
        throw RenderError("the graphics card has no room for " + std::to_string(capacity) + " bytes");
    // A driver that refuses to map leaves a buffer that is written as any other.
    if (mapping == Mapping::kept) storage.place = static_cast<std::byte*>(glMapBufferRange(kTarget, 0, size, kKept));
    return storage;
}

// A buffer of no bytes cannot be mapped or copied.
GrowingBuffer::GrowingBuffer(std::uint64_t capacity, Mapping mapping)
    : storage_(allocated(std::max<std::uint64_t>(capacity, 1), mapping)),
      capacity_(std::max<std::uint64_t>(capacity, 1))
{
}

bool GrowingBuffer::write(std::uint64_t offset, std::span<const std::byte> bytes)
{
    if (bytes.empty()) return false;
    const std::uint64_t end = offset + bytes.size();
    const bool must_grow = end > capacity_;
    if (must_grow) {
        const std::uint64_t capacity = std::max(end, 2 * capacity_);
        Storage larger = allocated(capacity, mapping_for(capacity));
        glBindBuffer(GL_COPY_READ_BUFFER, id());
        if (used_ != 0) glCopyBufferSubData(GL_COPY_READ_BUFFER, kTarget, 0, 0, static_cast<GLsizeiptr>(used_));
        glBindBuffer(GL_COPY_READ_BUFFER, 0);
        bytes_copied_ += used_;
        storage_ = std::move(larger);
        capacity_ = capacity;
    }
    // Nothing drawn so far reads these bytes, so there is nothing to wait for.
    if (storage_.place != nullptr)
        std::memcpy(storage_.place + offset, bytes.data(), bytes.size());
    else
        write_mapping(offset, bytes);
    used_ = std::max(used_, end);
    return must_grow;
}

void GrowingBuffer::write_mapping(std::uint64_t offset, std::span<const std::byte> bytes)
{
    glBindBuffer(kTarget, id());
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
}

}  // namespace kerf::render
