#include "viewer/render/fragment_store.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "common/cutting/back_end_helpers.h"

namespace kerf::render {

namespace {

void describe_vertices(const SharedBuffers& buffers)
{
    glBindVertexArray(buffers.vertex_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices.id());
    const auto attribute = [](GLuint location, GLint floats, std::size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, sizeof(Vertex), buffer_offset(offset));
    };
    attribute(0, 3, offsetof(Vertex, position));
    attribute(1, 3, offsetof(Vertex, normal));
    attribute(2, 2, offsetof(Vertex, uv));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.indices.id());
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

/// What a buffer starts with that holds so many bytes.
std::uint64_t capacity_for(std::uint64_t bytes, Room room)
{
    return bytes + (room == Room::to_grow ? std::min(bytes, kMostRoom) : 0);
}

std::vector<DrawBatch> batches_of(const DrawView& view, LookTable& looks)
{
    std::vector<DrawBatch> batches;
    for (const DrawRange& range : view.ranges) {
        const bool continues =
            !batches.empty() && batches.back().material == range.material && batches.back().kind == range.kind;
        if (!continues) {
            DrawBatch& batch = batches.emplace_back();
            batch.material = range.material;
            batch.kind = range.kind;
            batch.look = looks.index_of(view.materials, range.material, range.kind);
        }
        batches.back().runs.add(range.first_index, range.index_count);
    }
    return batches;
}

/// All ranges in the order of the buffer, those that follow one another joined.
IndexRuns everything_of(const DrawView& view)
{
    std::vector<DrawRange> ranges = view.ranges;
    for (DrawRange& range : ranges) {
        range.material = 0;
        range.kind = TriangleKind::surface;
    }
    merge_ranges(ranges);
    IndexRuns runs;
    for (const DrawRange& range : ranges) runs.add(range.first_index, range.index_count);
    return runs;
}

}  // namespace

void IndexRuns::add(std::uint32_t first_index, std::uint32_t index_count)
{
    counts.push_back(static_cast<GLsizei>(index_count));
    offsets.push_back(buffer_offset(sizeof(std::uint32_t) * std::size_t{first_index}));
}

std::shared_ptr<SharedBuffers> FragmentStore::buffers_for(const DrawView& view, Room room, bool& is_new)
{
    const auto found = sets_.find(view.buffers);
    is_new = found == sets_.end();
    if (!is_new) return found->second;
    auto made = std::make_shared<SharedBuffers>(
        SharedBuffers{GrowingBuffer(capacity_for(view.vertices.size_bytes(), room)),
                      GrowingBuffer(capacity_for(view.indices.size_bytes(), room)), GlVertexArray::create()});
    describe_vertices(*made);
    sets_.emplace(view.buffers, made);
    return made;
}

DrawnFragment FragmentStore::add(Cuttable& object, Room room)
{
    const DrawView view = object.draw_view();
    bool is_new = false;
    const std::shared_ptr<SharedBuffers> buffers = buffers_for(view, room, is_new);

    bool has_moved = false;
    const auto upload = [&](GrowingBuffer& buffer, std::span<const std::byte> content,
                            const std::vector<ByteRange>& news) {
        for (const ByteRange& range : news) {
            has_moved |= buffer.write(range.offset, content.subspan(range.offset, range.size));
            bytes_uploaded_ += range.size;
        }
    };
    const auto vertices = std::as_bytes(view.vertices), indices = std::as_bytes(view.indices);
    // Buffers that were here once and were released must come anew, whole.
    const std::vector<ByteRange> all_vertices{{0, vertices.size()}}, all_indices{{0, indices.size()}};
    upload(buffers->vertices, vertices, is_new ? all_vertices : view.new_vertex_bytes);
    upload(buffers->indices, indices, is_new ? all_indices : view.new_index_bytes);
    if (has_moved) describe_vertices(*buffers);
    object.mark_uploaded(view);

    DrawnFragment drawn{buffers, batches_of(view, looks_), everything_of(view), 0, object.bounds()};
    for (const DrawRange& range : view.ranges) drawn.triangles += range.index_count / 3;
    return drawn;
}

std::uint64_t FragmentStore::bring(Cuttable& object, Arrival& arrival, std::uint64_t most, Room room)
{
    const DrawView view = object.draw_view();
    const auto vertices = std::as_bytes(view.vertices), indices = std::as_bytes(view.indices);
    if (!arrival.buffers) {
        // The index buffer gets its size when its turn comes.
        arrival.buffers = std::make_shared<SharedBuffers>(SharedBuffers{
            GrowingBuffer(capacity_for(vertices.size(), room)), GrowingBuffer(0), GlVertexArray::create()});
        arrival.bytes = vertices.size() + indices.size();
        arriving_.push_back(arrival.buffers);
    }
    std::uint64_t left = most;
    const auto go_on = [&](GrowingBuffer& buffer, std::span<const std::byte> content, std::uint64_t& done) {
        const std::uint64_t size = std::min<std::uint64_t>(content.size() - done, left);
        buffer.write(done, content.subspan(done, size));
        done += size;
        left -= size;
    };
    go_on(arrival.buffers->vertices, vertices, arrival.vertex_bytes);
    if (left > 0 && arrival.index_bytes == 0)
        arrival.buffers->indices = GrowingBuffer(capacity_for(indices.size(), room));
    go_on(arrival.buffers->indices, indices, arrival.index_bytes);
    bytes_uploaded_ += most - left;
    if (arrival.vertex_bytes + arrival.index_bytes == arrival.bytes) {
        describe_vertices(*arrival.buffers);
        std::erase(arriving_, arrival.buffers);
        sets_[view.buffers] = arrival.buffers;
        object.mark_uploaded(view);
        arrival.is_whole = true;
    }
    return most - left;
}

void FragmentStore::release_unused()
{
    std::erase_if(sets_, [](const auto& entry) { return entry.second.use_count() == 1; });
    std::erase_if(arriving_, [](const auto& buffers) { return buffers.use_count() == 1; });
}

std::uint64_t FragmentStore::bytes_held() const
{
    std::uint64_t bytes = 0;
    const auto add = [&](const SharedBuffers& buffers) {
        bytes += buffers.vertices.capacity() + buffers.indices.capacity();
    };
    for (const auto& [key, buffers] : sets_) add(*buffers);
    for (const auto& buffers : arriving_) add(*buffers);
    return bytes;
}

}  // namespace kerf::render
