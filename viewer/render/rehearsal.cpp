#include "viewer/render/rehearsal.h"

#include <array>
#include <span>

namespace kerf::render {

namespace {

/// So many triangles make any speck dense: it is shaded from the geometry buffer then.
constexpr GLsizei kMany = 64;
/// Half the sides of the boxes that are said to be around them, world units: some pixels, and a good part of the picture.
constexpr float kSmall = 0.01f, kLarge = 1.0f;

/// Of a piece: some looks. A driver's memory for commands grows as it is needed, and is kept: the first frame with 300 pieces
/// took 12 ms of a thread more without.
constexpr std::size_t kDrawsAPiece = 3;

}  // namespace

Rehearsal::Rehearsal(const std::vector<std::uint32_t>& surfaces, const std::vector<std::uint32_t>& caps,
                     std::size_t most_pieces)
{
    // All corners in one place: nothing is seen of them, and everything is made ready for them.
    const std::array<DrawVertex, 3> corners{
        {{{}, {0.0f, 0.0f, 1.0f}, {}}, {{}, {0.0f, 0.0f, 1.0f}, {}}, {{}, {0.0f, 0.0f, 1.0f}, {}}}};
    std::vector<std::uint32_t> indices;
    for (GLsizei i = 0; i < 3 * kMany; ++i) indices.push_back(static_cast<std::uint32_t>(i % 3));
    auto made = std::make_shared<SharedBuffers>(SharedBuffers{
        GrowingBuffer(sizeof corners), GrowingBuffer(indices.size() * sizeof(std::uint32_t)), GlVertexArray::create()});
    made->vertices.write(0, std::as_bytes(std::span(corners)));
    made->indices.write(0, std::as_bytes(std::span(indices)));
    constexpr std::array<std::uint32_t, 3> kFirstMember{};
    made->members.emplace(sizeof kFirstMember);
    made->members->write(0, std::as_bytes(std::span(kFirstMember)));
    describe_vertices(*made);
    buffers_ = std::move(made);
    const auto add_all = [&](const std::vector<std::uint32_t>& looks, TriangleKind kind) {
        for (const std::uint32_t look : looks) {
            add(look, kind, 1, kLarge);
            add(look, kind, kMany, kSmall);
            if (most_pieces >= Swarm::kFewestMembers) add(look, kind, 1, kLarge, 0u);
        }
    };
    add_all(surfaces, TriangleKind::surface);
    add_all(caps, TriangleKind::cap);
    for (std::size_t i = 0, all = objects_.size(); all > 0 && objects_.size() < kDrawsAPiece * most_pieces; ++i)
        objects_.push_back(objects_[i % all]);
}

void Rehearsal::add(std::uint32_t look, TriangleKind kind, GLsizei triangles, float reach,
                    std::optional<std::uint32_t> member)
{
    auto fragment = std::make_unique<DrawnFragment>();
    fragment->buffers = buffers_;
    DrawBatch& batch = fragment->batches.emplace_back();
    batch.look = look;
    batch.kind = kind;
    batch.runs.add(0, static_cast<std::uint32_t>(3 * triangles));
    fragment->everything = batch.runs;
    fragment->triangles = static_cast<std::uint64_t>(triangles);
    fragment->member = member;
    fragment->bounds = {{-reach, -reach, -reach}, {reach, reach, reach}};
    for (const bool is_closed : {true, false}) {
        DrawnObject object;
        object.fragment = fragment.get();
        object.is_closed = is_closed;
        objects_.push_back(object);
    }
    fragments_.push_back(std::move(fragment));
}

}  // namespace kerf::render
