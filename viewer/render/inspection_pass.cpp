#include "viewer/render/inspection_pass.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec2.hpp>

#include "viewer/render/render_error.h"

namespace kerf::render {

namespace {

GlTexture attachment(GLenum point, GLenum internal_format, GLenum format, GLenum type, int width, int height)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.id(), 0);
    return texture;
}

template <typename Pixel>
std::vector<Pixel> read_back(GLenum point, GLenum format, GLenum type, int width, int height)
{
    std::vector<Pixel> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glReadBuffer(point);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, format, type, pixels.data());
    return pixels;
}

}  // namespace

InspectionPass::InspectionPass(int width, int height)
    : width_(width),
      height_(height),
      program_({"frame.glsl", "one_model.glsl", "surface.vert"}, {"inspection.frag"}),
      framebuffer_(GlFramebuffer::create())
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    ids_ = attachment(GL_COLOR_ATTACHMENT0, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, width, height);
    places_ = attachment(GL_COLOR_ATTACHMENT1, GL_RGBA32F, GL_RGBA, GL_FLOAT, width, height);
    uvs_ = attachment(GL_COLOR_ATTACHMENT2, GL_RG32F, GL_RG, GL_FLOAT, width, height);
    depth_ = attachment(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, width, height);
    constexpr std::array<GLenum, 3> kTargets{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    glDrawBuffers(static_cast<GLsizei>(kTargets.size()), kTargets.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw RenderError("the graphics driver cannot draw into integers and floats");
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<PixelFacts> InspectionPass::draw(const Viewpoint& viewpoint, std::span<const DrawnObject> objects)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    constexpr std::array<GLuint, 4> kNothing{};
    constexpr std::array<GLfloat, 4> kZero{};
    constexpr GLfloat kFar = 1.0f;
    glClearBufferuiv(GL_COLOR, 0, kNothing.data());
    glClearBufferfv(GL_COLOR, 1, kZero.data());
    glClearBufferfv(GL_COLOR, 2, kZero.data());
    glClearBufferfv(GL_DEPTH, 0, &kFar);

    FrameBlock frame;
    frame.view_projection = viewpoint.projection * viewpoint.view;
    uniforms_.set(frame);
    program_.use();
    const GLint model = program_.uniform("model"), scale = program_.uniform("pattern_scale");
    const GLint id = program_.uniform("object_id"), kind = program_.uniform("kind");
    const GLint clipped = program_.uniform("clipped");
    for (const DrawnObject& object : objects) {
        glBindVertexArray(object.fragment->buffers->vertex_array.id());
        glUniformMatrix4fv(model, 1, GL_FALSE, glm::value_ptr(object.model));
        glUniform1f(scale, object.pattern_scale);
        glUniform1ui(id, object.id);
        glUniform1f(clipped, object.is_clipped ? 1.0f : 0.0f);
        cull_for(object);
        for (const DrawBatch& batch : object.fragment->batches) {
            glUniform1ui(kind, 1u + static_cast<GLuint>(batch.kind));
            glMultiDrawElements(GL_TRIANGLES, batch.runs.counts.data(), GL_UNSIGNED_INT, batch.runs.offsets.data(),
                                static_cast<GLsizei>(batch.runs.counts.size()));
        }
    }
    end_culling();
    glBindVertexArray(0);

    const auto ids = read_back<glm::uvec2>(GL_COLOR_ATTACHMENT0, GL_RG_INTEGER, GL_UNSIGNED_INT, width_, height_);
    const auto places = read_back<glm::vec4>(GL_COLOR_ATTACHMENT1, GL_RGBA, GL_FLOAT, width_, height_);
    const auto uvs = read_back<glm::vec2>(GL_COLOR_ATTACHMENT2, GL_RG, GL_FLOAT, width_, height_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);

    std::vector<PixelFacts> facts(ids.size());
    const std::size_t row = static_cast<std::size_t>(width_), rows = static_cast<std::size_t>(height_);
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < row; ++x) {
            const std::size_t from = (rows - 1 - y) * row + x;
            if (ids[from].x == 0) continue;
            facts[y * row + x] = {ids[from].x, ids[from].y, glm::vec3(places[from]), places[from].w, uvs[from]};
        }
    return facts;
}

}  // namespace kerf::render
