#include "viewer/render/geometry_buffer.h"

#include "viewer/render/render_error.h"

namespace kerf::render {

namespace {

GlTexture attachment(GLenum point, GLenum format, int width, int height, int samples)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture.id());
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, width, height, GL_TRUE);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D_MULTISAMPLE, texture.id(), 0);
    return texture;
}

}  // namespace

GeometryBuffer::GeometryBuffer(int width, int height, int samples)
    : width_(width), height_(height), samples_(samples), framebuffer_(GlFramebuffer::create())
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    surfaces_ = attachment(GL_COLOR_ATTACHMENT0, GL_RGBA16F, width, height, samples);
    depth_ = attachment(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height, samples);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw RenderError("the graphics driver cannot draw normals of several samples a pixel");
}

void GeometryBuffer::begin() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
    // What is as far as can be is nothing: the normals of the last frame need not be cleared.
    glClear(GL_DEPTH_BUFFER_BIT);
}

void GeometryBuffer::copy_depth_to(GLuint framebuffer, int x, int y) const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, width_, height_, x, y, x + width_, y + height_, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void GeometryBuffer::bind_textures(GLint surfaces_unit, GLint depth_unit) const
{
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(surfaces_unit));
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, surfaces_.id());
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(depth_unit));
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, depth_.id());
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace kerf::render
