#include "viewer/render/scene_renderer.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <vector>

namespace kerf::render {

namespace {

/// Around the middle of the stage: everything that throws a shadow onto what a 16:9 window sees of the wall.
constexpr float kShadowRadius = 12.5f;

PictureTarget target_of(const SceneRenderer::Area& area)
{
    GLint framebuffer = 0, samples = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_SAMPLES, &samples);
    return {static_cast<GLuint>(framebuffer), samples, area.x, area.y, area.width, area.height};
}

}  // namespace

SceneRenderer::SceneRenderer(const LookTable& looks)
    : looks_(looks),
      programs_(looks),
      depth_({"one_model.glsl", "depth.vert"}, {"depth.frag"}),
      wire_({"frame.glsl", "wire.vert"}, {"wire.frag"}, {"frame.glsl", "wire.geom"})
{
}

void SceneRenderer::draw(const Viewpoint& viewpoint, std::span<const DrawnObject> objects, const DrawOptions& options,
                         const Area& area)
{
    statistics_ = {};
    const PictureTarget target = target_of(area);
    const Lights& lights = options.lights;
    const glm::mat4 shadow_projection = ShadowMap::projection(lights.to_light, kShadowRadius);

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    swarms_.place(objects);
    draw_shadows(objects, shadow_projection, options.clip);

    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(area.x, area.y, area.width, area.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x, area.y, area.width, area.height);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_FRAMEBUFFER_SRGB);

    FrameBlock frame;
    frame.view_projection = viewpoint.projection * viewpoint.view;
    frame.shadow_transform = ShadowMap::lookup(shadow_projection);
    frame.eye = {viewpoint.eye, ShadowMap::texel(kShadowRadius)};
    frame.to_light = {lights.to_light, lights.shadow};
    frame.light_colour = {lights.key, 0.0f};
    frame.sky_colour = {lights.sky, 0.0f};
    frame.ground_colour = {lights.ground, 0.0f};
    frame.viewport = {area.width, area.height, lights.exposure, 0.0f};
    frame.to_world = glm::inverse(frame.view_projection);
    frame.clip = options.clip;
    frame.picture = {area.x, area.y, target.samples, 0.0f};
    uniforms_.set(frame);
    looks_.bind();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shadow_map_.texture());

    draw_surfaces(objects, frame.view_projection, options, target);
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x, area.y, area.width, area.height);
    // The wall last: what stands before it is not shaded twice.
    if (options.wall) wall_.draw();
    if (options.wireframe) draw_edges(objects);

    glBindTexture(GL_TEXTURE_2D, 0);
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
}

void SceneRenderer::warm_up(Pattern pattern)
{
    programs_.find(Lighting::textured, pattern, PointSource::triangle);
    if (deferred_.is_offered() && shades_from_geometry_buffer(pattern, TriangleKind::surface))
        programs_.find(Lighting::textured, pattern, PointSource::geometry_buffer);
}

void SceneRenderer::draw_shadows(std::span<const DrawnObject> objects, const glm::mat4& projection,
                                 const glm::vec4& clip)
{
    shadow_map_.begin();
    depth_.use();
    glUniformMatrix4fv(depth_.uniform("shadow_projection"), 1, GL_FALSE, glm::value_ptr(projection));
    const GLint model = depth_.uniform("model"), clip_of_object = depth_.uniform("clip");
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2.0f);
    for (const DrawnObject& object : objects) {
        if (!object.throws_shadow || SwarmPass::suits(object)) continue;
        glBindVertexArray(object.fragment->buffers->vertex_array.id());
        glUniformMatrix4fv(model, 1, GL_FALSE, glm::value_ptr(object.model));
        glUniform4fv(clip_of_object, 1, glm::value_ptr(object.is_clipped ? clip : glm::vec4(0.0f)));
        cull_for(object);
        // Light falls into what is clipped, and its far side stops it.
        if (object.is_clipped) glDisable(GL_CULL_FACE);
        draw_runs(object.fragment->everything, statistics_);
    }
    end_culling();
    swarms_.draw_shadows(objects, projection, statistics_);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void SceneRenderer::draw_surfaces(std::span<const DrawnObject> objects, const glm::mat4& view_projection,
                                  const DrawOptions& options, const PictureTarget& target)
{
    std::vector<PlacedDraw> deferred;
    std::vector<SurfaceDraw> of_swarms, others;
    for (const DrawnObject& object : objects) {
        const ScreenRectangle part =
            screen_rectangle(object.fragment->bounds, view_projection * object.model, target.width, target.height);
        if (part.is_empty()) continue;
        for (const DrawBatch& batch : object.fragment->batches) {
            const PlacedDraw draw{{&object, &batch}, part};
            // Members of swarms are small and many: the pass would take longer for each than to draw it takes.
            const bool is_of_swarm = SwarmPass::suits(object);
            const bool is_deferred = !is_of_swarm && options.deferred && deferred.size() < DeferredPass::kMostDraws &&
                                     deferred_.suits(draw, looks_.look(batch.look).pattern, options.lighting, target);
            if (is_deferred)
                deferred.push_back(draw);
            else
                (is_of_swarm ? of_swarms : others).push_back(draw.surface);
        }
    }
    if (!deferred.empty()) {
        deferred_.fill(deferred, target, statistics_);
        deferred_.shade(deferred, options.lighting, target, programs_);
    }
    swarms_.draw_surfaces(of_swarms, options.lighting, programs_, statistics_);
    draw_at_once(others, options.lighting);
}

void SceneRenderer::draw_at_once(std::span<const SurfaceDraw> draws, Lighting lighting)
{
    programs_.begin();
    for (const SurfaceDraw& draw : draws) {
        glBindVertexArray(draw.object->fragment->buffers->vertex_array.id());
        cull_for(*draw.object);
        programs_.use(draw, lighting, PointSource::triangle);
        draw_runs(draw.batch->runs, statistics_);
    }
    end_culling();
}

void SceneRenderer::draw_edges(std::span<const DrawnObject> objects)
{
    wire_.use();
    const GLint model = wire_.uniform("model"), colour = wire_.uniform("line_colour");
    const GLint clipped = wire_.uniform("clipped");
    glUniform1f(wire_.uniform("line_width"), 1.1f);
    // The same surface a second time: equal depth passes, and a little in front to be sure.
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0f, -1.0f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (const DrawnObject& object : objects) {
        glBindVertexArray(object.fragment->buffers->vertex_array.id());
        glUniformMatrix4fv(model, 1, GL_FALSE, glm::value_ptr(object.model));
        glUniform1f(clipped, object.is_clipped ? 1.0f : 0.0f);
        object.is_clipped ? glEnable(GL_CLIP_DISTANCE0) : glDisable(GL_CLIP_DISTANCE0);
        for (const DrawBatch& batch : object.fragment->batches) {
            if (batch.kind == TriangleKind::cap)
                glUniform4f(colour, 1.0f, 0.93f, 0.72f, 0.95f);
            else
                glUniform4f(colour, 0.01f, 0.012f, 0.015f, 0.6f);
            draw_runs(batch.runs, statistics_);
        }
    }
    end_culling();
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

}  // namespace kerf::render
