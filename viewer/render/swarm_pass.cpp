#include "viewer/render/swarm_pass.h"

#include <glm/gtc/type_ptr.hpp>

namespace kerf::render {

namespace {

/// A swarm's matrices. Ranges of uniform buffers begin at multiples of 256 bytes with every driver.
constexpr std::size_t kBytesOfModels = sizeof(glm::mat4) * Swarm::kMostMembers;
static_assert(kBytesOfModels == 16u << 10, "as much as every driver offers");

}  // namespace

SwarmPass::SwarmPass() : depth_({"member_model.glsl", "depth.vert"}, {"depth.frag"}), models_(GlBuffer::create()) {}

bool SwarmPass::suits(const DrawnObject& object)
{
    return object.fragment->member && !object.is_clipped && object.throws_shadow;
}

void SwarmPass::place(std::span<const DrawnObject> objects)
{
    swarms_.clear();
    std::vector<glm::mat4> models;
    for (const DrawnObject& object : objects) {
        if (!suits(object)) continue;
        const std::size_t swarm = swarms_.try_emplace(object.fragment->buffers.get(), swarms_.size()).first->second;
        models.resize(swarms_.size() * Swarm::kMostMembers);
        models[swarm * Swarm::kMostMembers + *object.fragment->member] = object.model;
    }
    if (models.empty()) return;
    // New storage each time: the driver need not wait for the last frame's drawing to finish.
    glBindBuffer(GL_UNIFORM_BUFFER, models_.id());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(std::span(models).size_bytes()), models.data(),
                 GL_STREAM_DRAW);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
}

void SwarmPass::append(const IndexRuns& runs, IndexRuns& all)
{
    all.counts.insert(all.counts.end(), runs.counts.begin(), runs.counts.end());
    all.offsets.insert(all.offsets.end(), runs.offsets.begin(), runs.offsets.end());
}

void SwarmPass::draw(const Group& group, const IndexRuns& runs, DrawStatistics& statistics) const
{
    const auto from = static_cast<GLintptr>(swarms_.at(group.buffers) * kBytesOfModels);
    glBindBufferRange(GL_UNIFORM_BUFFER, static_cast<GLuint>(UniformBlock::swarm), models_.id(), from, kBytesOfModels);
    glBindVertexArray(group.buffers->vertex_array.id());
    draw_runs(runs, statistics);
}

void SwarmPass::draw_shadows(std::span<const DrawnObject> objects, const glm::mat4& projection,
                             DrawStatistics& statistics)
{
    Groups groups;
    for (const DrawnObject& object : objects) {
        if (!suits(object)) continue;
        Members& members = groups[{object.fragment->buffers.get(), object.is_closed}];
        members.first.object = &object;
        append(object.fragment->everything, members.runs);
    }
    if (groups.empty()) return;
    depth_.use();
    glUniformMatrix4fv(depth_.uniform("shadow_projection"), 1, GL_FALSE, glm::value_ptr(projection));
    for (const auto& [group, members] : groups) {
        cull_for(*members.first.object);
        draw(group, members.runs, statistics);
    }
    end_culling();
}

void SwarmPass::draw_surfaces(std::span<const SurfaceDraw> draws, Lighting lighting, SurfacePrograms& programs,
                              DrawStatistics& statistics)
{
    Groups groups;
    for (const SurfaceDraw& draw : draws) {
        const DrawnObject& object = *draw.object;
        Members& members = groups[{object.fragment->buffers.get(), object.is_closed, draw.batch->look, draw.batch->kind,
                                   object.pattern_scale}];
        members.first = draw;
        append(draw.batch->runs, members.runs);
    }
    programs.begin();
    for (const auto& [group, members] : groups) {
        cull_for(*members.first.object);
        programs.use(members.first, lighting, PointSource::swarm);
        draw(group, members.runs, statistics);
    }
    end_culling();
}

}  // namespace kerf::render
