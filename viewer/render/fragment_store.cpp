#include "viewer/render/fragment_store.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "viewer/render/render_error.h"

namespace kerf::render {

namespace {

/// A buffer for so many bytes. One that is written once is not worth to be kept mapped.
GrowingBuffer buffer_for(std::uint64_t bytes, Room room)
{
    if (room == Room::exact) return GrowingBuffer(bytes, Mapping::each_write);
    return GrowingBuffer(bytes + std::clamp(bytes, kLeastRoom, kMostRoom));
}

/// The materials of an object, their images where `images` says that they are.
std::vector<Material> materials_of(const Object& object, std::span<const std::string> images)
{
    std::vector<Material> materials;
    for (std::size_t i = 0; i < object.material_count(); ++i) {
        Material& material = materials.emplace_back(object.material(i));
        if (i < images.size()) material.base_colour_image = images[i].c_str();
    }
    return materials;
}

/// `first_index` is where the object's indices begin in the buffer, `look_of` gives the look of a material's triangles of a
/// kind.
template <class LookOf>
std::vector<DrawBatch> batches_of(const DrawView& view, std::uint32_t first_index, LookOf look_of)
{
    std::vector<DrawBatch> batches;
    for (const DrawRange& range : view.ranges) {
        const bool continues =
            !batches.empty() && batches.back().material == range.material && batches.back().kind == range.kind;
        if (!continues) {
            DrawBatch& batch = batches.emplace_back();
            batch.material = range.material;
            batch.kind = range.kind;
            batch.look = look_of(range.material, range.kind);
        }
        batches.back().runs.add(first_index + range.first_index, range.index_count);
    }
    return batches;
}

/// All ranges in the order of the buffer, those that follow one another joined.
IndexRuns everything_of(const DrawView& view, std::uint32_t first_index)
{
    std::vector<DrawRange> ranges(view.ranges.begin(), view.ranges.end());
    std::sort(ranges.begin(), ranges.end(),
              [](const DrawRange& a, const DrawRange& b) { return a.first_index < b.first_index; });
    IndexRuns runs;
    for (std::size_t i = 0; i < ranges.size();) {
        const std::uint32_t first = ranges[i].first_index;
        std::uint32_t end = first;
        for (; i < ranges.size() && ranges[i].first_index == end; ++i) end += ranges[i].index_count;
        runs.add(first_index + first, end - first);
    }
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
    auto made = std::make_shared<SharedBuffers>(SharedBuffers{buffer_for(view.vertices.size_bytes(), room),
                                                              buffer_for(view.indices.size_bytes(), room),
                                                              GlVertexArray::create()});
    describe_vertices(*made);
    sets_.emplace(view.buffers, made);
    return made;
}

const DrawView& FragmentStore::look_at(const Object& object)
{
    if (!ok(object.draw(view_))) throw RenderError("there is not enough memory to draw an object");
    return view_;
}

/// Uploads what is new of an object's buffers, all of it if they are new here, and tells the object so.
std::shared_ptr<SharedBuffers> FragmentStore::upload_new(Object& object, const DrawView& view, Room room)
{
    bool is_new = false;
    std::shared_ptr<SharedBuffers> buffers = buffers_for(view, room, is_new);

    bool has_moved = false;
    const auto upload = [&](GrowingBuffer& buffer, std::span<const std::byte> content, std::size_t from) {
        if (from == content.size()) return;
        has_moved |= buffer.write(from, content.subspan(from));
        bytes_uploaded_ += content.size() - from;
    };
    // Buffers that were here once and were released must come anew, whole.
    upload(buffers->vertices, std::as_bytes(view.vertices), is_new ? 0 : view.new_vertices_from * sizeof(DrawVertex));
    upload(buffers->indices, std::as_bytes(view.indices), is_new ? 0 : view.new_indices_from * sizeof(std::uint32_t));
    if (has_moved) describe_vertices(*buffers);
    object.mark_uploaded(view);
    return buffers;
}

bool FragmentStore::joins_a_swarm(const DrawView& view, Kin kin) const
{
    return kin != 0 && view.vertices.size_bytes() <= Swarm::kMostBytesOfAMember && !sets_.contains(view.buffers);
}

FragmentStore::Home FragmentStore::take_into_swarm(Object& object, const DrawView& view, Kin kin)
{
    std::vector<Swarm>& swarms = swarms_[kin];
    if (swarms.empty() || !swarms.back().has_room_for(view)) swarms.emplace_back();
    Home home{swarms.back().buffers(), swarms.back().take_in(view)};
    bytes_uploaded_ += view.vertices.size_bytes() + view.indices.size_bytes();
    object.mark_uploaded(view);
    return home;
}

FragmentStore::Home FragmentStore::home_for(Object& object, const DrawView& view, Room room, Kin kin)
{
    // Once: what is cut from a member gets buffers of its own.
    if (const auto newcomer = newcomers_.extract(view.buffers))
        if (auto buffers = newcomer.mapped().first.lock()) return {std::move(buffers), newcomer.mapped().second};
    if (joins_a_swarm(view, kin)) return take_into_swarm(object, view, kin);
    return {upload_new(object, view, room), {}};
}

DrawnFragment FragmentStore::add(Object& object, std::span<const std::string> images, Room room, Kin kin)
{
    const DrawView& view = look_at(object);
    const Home home = home_for(object, view, room, kin);

    const auto look_of = [&](std::uint32_t material, TriangleKind kind) {
        return home.buffers->looks.look(material, kind,
                                        [&] { return looks_.index_of(materials_of(object, images), material, kind); });
    };
    const std::uint32_t first_index = home.member ? home.member->first_index : 0;
    DrawnFragment drawn{
        home.buffers, batches_of(view, first_index, look_of), everything_of(view, first_index), 0, object.bounds(), {}};
    if (home.member) drawn.member = home.member->number;
    for (const DrawRange& range : view.ranges) drawn.triangles += range.index_count / 3;
    return drawn;
}

std::uint64_t FragmentStore::bring(Object& object, Arrival& arrival, std::uint64_t most, Room room, Kin kin)
{
    const DrawView& view = look_at(object);
    const auto vertices = std::as_bytes(view.vertices), indices = std::as_bytes(view.indices);
    // A relative of what is here: what it adds is little, and comes at once. And so do the small.
    const bool is_relative = sets_.contains(view.buffers), is_small = joins_a_swarm(view, kin);
    if (!arrival.buffers && (is_relative || is_small)) {
        const std::uint64_t before = bytes_uploaded_;
        if (is_relative) {
            arrival.buffers = upload_new(object, view, room);
        } else {
            const Home home = take_into_swarm(object, view, kin);
            newcomers_[view.buffers] = {home.buffers, *home.member};
            arrival.buffers = home.buffers;
        }
        arrival.bytes = arrival.vertex_bytes = bytes_uploaded_ - before;
        arrival.is_whole = true;
        return arrival.bytes;
    }
    if (!arrival.buffers) {
        // The index buffer gets its size when its turn comes.
        arrival.buffers = std::make_shared<SharedBuffers>(
            SharedBuffers{buffer_for(vertices.size(), room), buffer_for(0, Room::exact), GlVertexArray::create()});
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
    if (left > 0 && arrival.index_bytes == 0) arrival.buffers->indices = buffer_for(indices.size(), room);
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
    for (auto& [kin, swarms] : swarms_)
        std::erase_if(swarms, [](const Swarm& swarm) { return swarm.buffers().use_count() == 1; });
    std::erase_if(swarms_, [](const auto& entry) { return entry.second.empty(); });
    std::erase_if(newcomers_, [](const auto& entry) { return entry.second.first.expired(); });
}

std::size_t FragmentStore::buffer_sets() const
{
    std::size_t sets = sets_.size();
    for (const auto& [kin, swarms] : swarms_) sets += swarms.size();
    return sets;
}

std::uint64_t FragmentStore::bytes_held() const
{
    std::uint64_t bytes = 0;
    const auto add = [&](const SharedBuffers& buffers) {
        bytes += buffers.vertices.capacity() + buffers.indices.capacity();
        if (buffers.members) bytes += buffers.members->capacity();
    };
    for (const auto& [key, buffers] : sets_) add(*buffers);
    for (const auto& buffers : arriving_) add(*buffers);
    for (const auto& [kin, swarms] : swarms_)
        for (const Swarm& swarm : swarms) add(*swarm.buffers());
    return bytes;
}

}  // namespace kerf::render
