#pragma once

#include <kerf/export.h>
#include <kerf/math.h>
#include <kerf/mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace kerf {

/// @addtogroup drawing
/// What of an object's buffers goes to the GPU, and which runs of it are the object.
/// @{

/// A vertex as the buffers hold it: 32 bytes.
struct DrawVertex
{
    Vec3f position;  ///< in the mesh's unit of length
    Vec3f normal;    ///< length 1
    Vec2f uv;        ///< origin in the lower left corner
};
static_assert(sizeof(DrawVertex) == 32);

/// A run of the index buffer that is drawn in one call.
struct DrawRange
{
    std::uint32_t first_index = 0;              ///< of DrawView::indices
    std::uint32_t index_count = 0;              ///< three for each triangle
    std::uint32_t material = 0;                 ///< Object::material()
    TriangleKind kind = TriangleKind::surface;  ///< surface or cap: no range has both
};

/// What to draw. Relatives (Object::shares_buffers_with()) have the same buffers: each of their views names all of
/// them, and ranges of its own. What a view shows stays where and as it is until the object ends or is cut,
/// detached or compacted, also while relatives are cut: buffers only grow, behind what a view shows.
///
/// One view can be filled again and again (Object::draw()), which saves the allocation of its ranges in each frame.
///
///     object.draw(view);
///     upload(view.buffers, view.vertices.subspan(view.new_vertices_from),
///            view.indices.subspan(view.new_indices_from));
///     object.mark_uploaded(view);
///     for (const kerf::DrawRange& range : view.ranges) draw(view.buffers, range);
struct KERF_API DrawView
{
    std::uint64_t buffers =
        0;  ///< a serial number that no other buffers of the program ever get: the key of your GPU buffers
    std::span<const DrawVertex> vertices;    ///< the whole vertex buffer
    std::span<const std::uint32_t> indices;  ///< the whole index buffer
    std::size_t new_vertices_from = 0;       ///< what stands before is on the GPU already, as mark_uploaded() was told
    std::size_t new_indices_from = 0;        ///< the same of indices
    std::span<const Stream> streams;         ///< further numbers of all vertices; new from `new_vertices_from` on, too
    std::span<const DrawRange> ranges;       ///< by kind and material

    /// One that shows nothing; what is moved from is such a one.
    /// @{
    DrawView() noexcept = default;
    DrawView(DrawView&& other) noexcept;
    DrawView& operator=(DrawView&& other) noexcept;
    /// @}
    ~DrawView();

private:
    friend class Object;
    struct Room;
    Room* room_ = nullptr;
};

/// Told when buffers are gone, so that their copies on the GPU can go, too.
struct BufferListener
{
    /// Called once for each serial number, from the thread that ended the last object with these buffers. Must not call
    /// the library. May be null.
    void (*released)(void* user, std::uint64_t buffers) = nullptr;
    void* user = nullptr;  ///< for `released`
};

/// @}

}  // namespace kerf
