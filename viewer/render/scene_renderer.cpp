#include "viewer/render/scene_renderer.h"

#include <glm/gtc/type_ptr.hpp>
#include <utility>

namespace kerf::render {

namespace {

/// Around the middle of the stage: everything that throws a shadow onto what a 16:9 window sees of the wall.
constexpr float kShadowRadius = 12.5f;

/// The shadow map has unit 0.
constexpr GLint kImageUnit = 1;

ShaderProgram surface_program(const ShaderFiles& fragment_files)
{
    return ShaderProgram({"frame.glsl", "surface.vert"}, fragment_files);
}

}  // namespace

void cull_for(const DrawnObject& object)
{
    // What is seen of an open mesh's back is drawn, too.
    if (object.is_closed)
        glEnable(GL_CULL_FACE);
    else
        glDisable(GL_CULL_FACE);
}

SceneRenderer::SurfaceProgram::SurfaceProgram(ShaderProgram linked)
    : program(std::move(linked)),
      model(program.uniform("model")),
      pattern_scale(program.uniform("pattern_scale")),
      look_index(program.uniform("look_index")),
      is_cap(program.uniform("is_cap"))
{
    program.use();
    glUniform1i(program.uniform("shadow_map"), 0);
    if (const GLint image = program.uniform("image"); image >= 0) glUniform1i(image, kImageUnit);
}

SceneRenderer::SceneRenderer(const LookTable& looks)
    : looks_(looks),
      lambert_(surface_program({"frame.glsl", "tone.glsl", "shadow.glsl", "surface_look.glsl", "lambert.frag"})),
      depth_({"depth.vert"}, {"depth.frag"}),
      wire_({"frame.glsl", "wire.vert"}, {"wire.frag"}, {"frame.glsl", "wire.geom"})
{
}

void SceneRenderer::draw(const Viewpoint& viewpoint, std::span<const DrawnObject> objects, const DrawOptions& options,
                         const Area& area)
{
    statistics_ = {};
    GLint target = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    const Lights& lights = options.lights;
    const glm::mat4 shadow_projection = ShadowMap::projection(lights.to_light, kShadowRadius);

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    draw_shadows(objects, shadow_projection);

    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
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
    uniforms_.set(frame);
    looks_.bind();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shadow_map_.texture());

    draw_surfaces(objects, options.lighting);
    // The wall last: what stands before it is not shaded twice.
    if (options.wall) wall_.draw();
    if (options.wireframe) draw_edges(objects);

    glBindTexture(GL_TEXTURE_2D, 0);
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
}

void SceneRenderer::draw_runs(const IndexRuns& runs)
{
    glMultiDrawElements(GL_TRIANGLES, runs.counts.data(), GL_UNSIGNED_INT, runs.offsets.data(),
                        static_cast<GLsizei>(runs.counts.size()));
    ++statistics_.calls;
    statistics_.ranges += runs.counts.size();
}

void SceneRenderer::draw_shadows(std::span<const DrawnObject> objects, const glm::mat4& projection)
{
    shadow_map_.begin();
    depth_.use();
    glUniformMatrix4fv(depth_.uniform("shadow_projection"), 1, GL_FALSE, glm::value_ptr(projection));
    const GLint model = depth_.uniform("model");
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2.0f);
    for (const DrawnObject& object : objects) {
        glBindVertexArray(object.fragment->buffers->vertex_array.id());
        glUniformMatrix4fv(model, 1, GL_FALSE, glm::value_ptr(object.model));
        cull_for(object);
        draw_runs(object.fragment->everything);
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

const SceneRenderer::SurfaceProgram& SceneRenderer::textured(Pattern pattern)
{
    const std::span<const std::string_view> own = shaders_of(pattern);
    const auto known = textured_.find(own.data());
    if (known != textured_.end()) return known->second;
    ShaderFiles files{"frame.glsl", "tone.glsl", "shadow.glsl", "noise.glsl", "surface_look.glsl"};
    files.insert(files.end(), own.begin(), own.end());
    files.push_back("textured.frag");
    return textured_.emplace(own.data(), SurfaceProgram(surface_program(files))).first->second;
}

void SceneRenderer::draw_surfaces(std::span<const DrawnObject> objects, Lighting lighting)
{
    const SurfaceProgram* in_use = nullptr;
    std::uint32_t bound_image = 0;
    for (const DrawnObject& object : objects) {
        glBindVertexArray(object.fragment->buffers->vertex_array.id());
        cull_for(object);
        bool is_placed = false;
        for (const DrawBatch& batch : object.fragment->batches) {
            const SurfaceProgram& surface =
                lighting == Lighting::lambert ? lambert_ : textured(looks_.look(batch.look).pattern);
            if (&surface != in_use) surface.program.use();
            if (&surface != in_use || !is_placed) {
                glUniformMatrix4fv(surface.model, 1, GL_FALSE, glm::value_ptr(object.model));
                glUniform1f(surface.pattern_scale, object.pattern_scale);
            }
            in_use = &surface;
            is_placed = true;
            if (const std::uint32_t image = looks_.look(batch.look).image; image != 0 && image != bound_image) {
                glActiveTexture(GL_TEXTURE0 + kImageUnit);
                glBindTexture(GL_TEXTURE_2D, looks_.images().texture(image));
                glActiveTexture(GL_TEXTURE0);
                bound_image = image;
            }
            glUniform1i(surface.look_index, static_cast<GLint>(batch.look));
            glUniform1i(surface.is_cap, batch.kind == TriangleKind::cap ? 1 : 0);
            draw_runs(batch.runs);
        }
    }
    glDisable(GL_CULL_FACE);
}

void SceneRenderer::draw_edges(std::span<const DrawnObject> objects)
{
    wire_.use();
    const GLint model = wire_.uniform("model"), colour = wire_.uniform("line_colour");
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
        for (const DrawBatch& batch : object.fragment->batches) {
            if (batch.kind == TriangleKind::cap)
                glUniform4f(colour, 1.0f, 0.93f, 0.72f, 0.95f);
            else
                glUniform4f(colour, 0.01f, 0.012f, 0.015f, 0.6f);
            draw_runs(batch.runs);
        }
    }
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

}  // namespace kerf::render
