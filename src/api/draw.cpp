#include <kerf/object.h>

#include <memory>
#include <vector>

#include "api/no_memory.h"
#include "common/cutting/cut.h"

namespace kerf {

static_assert(sizeof(DrawVertex) == sizeof(core::Vertex));
static_assert(int(TriangleKind::surface) == int(core::TriangleKind::surface) &&
              int(TriangleKind::cap) == int(core::TriangleKind::cap));

/// What a view points to, besides the buffers.
struct DrawView::Room
{
    std::vector<DrawRange> ranges;
    std::vector<Stream> streams;
};

namespace {

/// The first element that is new, if `ranges` are the new bytes.
std::size_t new_from(const std::vector<core::ByteRange>& ranges, std::size_t element_size, std::size_t count)
{
    return ranges.empty() ? count : static_cast<std::size_t>(ranges.front().offset) / element_size;
}

}  // namespace

DrawView::DrawView(DrawView&& other) noexcept
    : buffers(std::exchange(other.buffers, 0)),
      vertices(std::exchange(other.vertices, {})),
      indices(std::exchange(other.indices, {})),
      new_vertices_from(std::exchange(other.new_vertices_from, 0)),
      new_indices_from(std::exchange(other.new_indices_from, 0)),
      streams(std::exchange(other.streams, {})),
      ranges(std::exchange(other.ranges, {})),
      room_(std::exchange(other.room_, nullptr))
{
}

DrawView& DrawView::operator=(DrawView&& other) noexcept
{
    DrawView taken(std::move(other));
    std::swap(buffers, taken.buffers);
    std::swap(vertices, taken.vertices);
    std::swap(indices, taken.indices);
    std::swap(new_vertices_from, taken.new_vertices_from);
    std::swap(new_indices_from, taken.new_indices_from);
    std::swap(streams, taken.streams);
    std::swap(ranges, taken.ranges);
    std::swap(room_, taken.room_);
    return *this;
}

DrawView::~DrawView()
{
    delete room_;
}

Status Object::draw(DrawView& view) const noexcept
{
    DrawView::Room* const room = std::exchange(view.room_, nullptr);
    view = DrawView();
    view.room_ = room;
    if (is_empty()) return Status::invalid_argument;
    return answer_or(Status::out_of_memory, [&] {
        if (view.room_ == nullptr) view.room_ = std::make_unique<DrawView::Room>().release();
        const core::DrawView inside = inside_->draw_view();
        std::vector<DrawRange>& ranges = view.room_->ranges;
        std::vector<Stream>& streams = view.room_->streams;
        ranges.clear();
        for (const core::DrawRange& range : inside.ranges)
            ranges.push_back(
                {range.first_index, range.index_count, range.material, static_cast<TriangleKind>(range.kind)});
        streams.clear();
        for (const core::StreamView& stream : inside.streams)
            streams.push_back({stream.name.data(), stream.width, stream.values});
        view.buffers = inside.buffers;
        view.vertices = {reinterpret_cast<const DrawVertex*>(inside.vertices.data()), inside.vertices.size()};
        view.indices = inside.indices;
        view.new_vertices_from = new_from(inside.new_vertex_bytes, sizeof(core::Vertex), inside.vertices.size());
        view.new_indices_from = new_from(inside.new_index_bytes, sizeof(std::uint32_t), inside.indices.size());
        view.streams = streams;
        view.ranges = ranges;
        return Status::done;
    });
}

void Object::mark_uploaded(const DrawView& view) noexcept
{
    if (is_empty()) return;
    core::DrawView inside;
    inside.buffers = view.buffers;
    inside.vertices = {reinterpret_cast<const core::Vertex*>(view.vertices.data()), view.vertices.size()};
    inside.indices = view.indices;
    inside_->mark_uploaded(inside);
}

}  // namespace kerf
