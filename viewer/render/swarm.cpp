#include "viewer/render/swarm.h"

#include <span>
#include <vector>

namespace kerf::render {

namespace {

/// What 300 pieces of a thousand triangles need of vertices, about.
constexpr std::uint64_t kVertexBytes = 1u << 20;

}  // namespace

Swarm::Swarm()
    : buffers_(std::make_shared<SharedBuffers>(
          SharedBuffers{GrowingBuffer(kVertexBytes), GrowingBuffer(kVertexBytes / 4), GlVertexArray::create()}))
{
    buffers_->members.emplace(kVertexBytes * sizeof(std::uint32_t) / sizeof(DrawVertex));
    describe_vertices(*buffers_);
}

bool Swarm::has_room_for(const DrawView& view) const
{
    return members_ < kMostMembers && vertices_ * sizeof(DrawVertex) + view.vertices.size_bytes() <= kMostBytes;
}

Swarm::Member Swarm::take_in(const DrawView& view)
{
    const std::vector<std::uint32_t> owners(view.vertices.size(), members_);
    std::vector<std::uint32_t> indices(view.indices.begin(), view.indices.end());
    for (std::uint32_t& index : indices) index += static_cast<std::uint32_t>(vertices_);

    bool has_moved = buffers_->vertices.write(vertices_ * sizeof(DrawVertex), std::as_bytes(view.vertices));
    has_moved |= buffers_->members->write(vertices_ * sizeof(std::uint32_t), std::as_bytes(std::span(owners)));
    has_moved |= buffers_->indices.write(indices_ * sizeof(std::uint32_t), std::as_bytes(std::span(indices)));
    if (has_moved) describe_vertices(*buffers_);

    const Member member{members_, static_cast<std::uint32_t>(indices_)};
    ++members_;
    vertices_ += view.vertices.size();
    indices_ += indices.size();
    return member;
}

}  // namespace kerf::render
