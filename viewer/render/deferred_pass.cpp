#include "viewer/render/deferred_pass.h"

#include <glm/gtc/type_ptr.hpp>
#include <numeric>

namespace kerf::render {

namespace {

/// Of its rectangle on the screen. With fewer triangles in it a surface is shaded while it is drawn: hardly a pixel is
/// shaded twice then.
constexpr std::int64_t kPixelsATriangle = 8;

std::int64_t triangles_of(const DrawBatch& batch)
{
    return std::accumulate(batch.runs.counts.begin(), batch.runs.counts.end(), std::int64_t{0}) / 3;
}

}  // namespace

DeferredPass::DeferredPass()
    : is_offered_(epoxy_has_gl_extension("GL_ARB_sample_shading")),
      program_({"frame.glsl", "one_model.glsl", "surface.vert"}, {"geometry.frag"}),
      nothing_(GlVertexArray::create())
{
}

bool DeferredPass::suits(const PlacedDraw& draw, Pattern pattern, Lighting lighting, const PictureTarget& target) const
{
    const DrawBatch& batch = *draw.surface.batch;
    if (!is_offered_ || target.samples == 0) return false;
    if (lighting == Lighting::textured && !shades_from_geometry_buffer(pattern, batch.kind)) return false;
    return kPixelsATriangle * triangles_of(batch) >= draw.rectangle.pixels();
}

void DeferredPass::fill(std::span<const PlacedDraw> draws, const PictureTarget& target, DrawStatistics& statistics)
{
    if (!buffer_ || !buffer_->is_for(target.width, target.height, target.samples))
        buffer_.emplace(target.width, target.height, target.samples);
    glDisable(GL_SCISSOR_TEST);
    buffer_->begin();
    program_.use();
    const GLint model = program_.uniform("model"), number = program_.uniform("batch");
    const GLint clipped = program_.uniform("clipped");
    for (std::size_t i = 0; i < draws.size(); ++i) {
        const SurfaceDraw& surface = draws[i].surface;
        glBindVertexArray(surface.object->fragment->buffers->vertex_array.id());
        glUniformMatrix4fv(model, 1, GL_FALSE, glm::value_ptr(surface.object->model));
        glUniform1f(number, static_cast<float>(i));
        glUniform1f(clipped, surface.object->is_clipped ? 1.0f : 0.0f);
        cull_for(*surface.object);
        draw_runs(surface.batch->runs, statistics);
    }
    end_culling();
}

void DeferredPass::shade(std::span<const PlacedDraw> draws, Lighting lighting, const PictureTarget& target,
                         SurfacePrograms& programs) const
{
    buffer_->copy_depth_to(target.framebuffer, target.x, target.y);
    buffer_->bind_textures(SurfaceUnits::kGeometry, SurfaceUnits::kGeometryDepth);
    glBindVertexArray(nothing_.id());
    glViewport(target.x, target.y, target.width, target.height);
    // The screen is covered as far away as can be: what is nearer is something, and only that is shaded.
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glEnable(GL_SCISSOR_TEST);
    programs.begin();
    for (std::size_t i = 0; i < draws.size(); ++i) {
        const ScreenRectangle& part = draws[i].rectangle;
        glScissor(target.x + part.x, target.y + part.y, part.width, part.height);
        const SurfaceProgram& surface = programs.use(draws[i].surface, lighting, PointSource::geometry_buffer);
        glUniform1f(surface.batch, static_cast<float>(i));
        for (const GLint is_behind : {0, 1}) {
            glUniform1i(surface.is_behind, is_behind);
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
    }
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

}  // namespace kerf::render
