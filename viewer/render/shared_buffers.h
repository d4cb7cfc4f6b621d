#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <kerf/object.h>

#include "viewer/render/growing_buffer.h"

namespace kerf::render {

/// What each material looks like, on the surface and on caps: indices into the LookTable, found once. Cuts add materials to
/// those that there are, and change none.
class KnownLooks
{
public:
    /// `find()` gives the index if it is not known yet.
    template <class Find>
    std::uint32_t look(std::uint32_t material, TriangleKind kind, Find find)
    {
        if (material >= looks_.size()) looks_.resize(std::size_t{material} + 1, {kUnknown, kUnknown});
        std::uint32_t& known = looks_[material][static_cast<std::size_t>(kind)];
        if (known == kUnknown) known = find();
        return known;
    }

private:
    static constexpr std::uint32_t kUnknown = 0xFFFFFFFFu;

    std::vector<std::array<std::uint32_t, 2>> looks_;  ///< by material and kind
};

/// Vertex and index buffer that fragments share, the vertex array over them, and the looks of the fragments' materials.
struct SharedBuffers
{
    GrowingBuffer vertices;
    GrowingBuffer indices;
    GlVertexArray vertex_array;
    KnownLooks looks{};
    /// Of a Swarm: for each vertex the number of the member that it belongs to (std::uint32_t).
    std::optional<GrowingBuffer> members{};
};

/// Says how the buffers' vertices (DrawVertex, and their members) are to be read; again whenever one of the buffers has
/// moved.
void describe_vertices(const SharedBuffers& buffers);

}  // namespace kerf::render
