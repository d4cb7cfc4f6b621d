#include "viewer/render/frame_target.h"

#include <algorithm>
#include <cstddef>

#include "viewer/render/render_error.h"

namespace kerf::render {

namespace {

GlRenderbuffer storage(GLenum format, int samples, int width, int height)
{
    GlRenderbuffer buffer = GlRenderbuffer::create();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return buffer;
}

void check_complete()
{
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw RenderError("the graphics driver cannot draw into a picture of this size and kind");
}

int samples_offered(int wanted)
{
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    return std::min(wanted, most);
}

}  // namespace

FrameTarget::FrameTarget(int width, int height, int samples) : width_(std::max(width, 1)), height_(std::max(height, 1))
{
    samples = samples_offered(samples);
    colour_ = storage(GL_SRGB8_ALPHA8, samples, width_, height_);
    depth_ = storage(GL_DEPTH_COMPONENT24, samples, width_, height_);
    samples_ = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, samples_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    check_complete();

    picture_ = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, picture_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    resolved_ = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_.id(), 0);
    check_complete();
}

void FrameTarget::bind() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, samples_.id());
    glViewport(0, 0, width_, height_);
    glEnable(GL_FRAMEBUFFER_SRGB);
}

void FrameTarget::resolve() const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
    glDisable(GL_FRAMEBUFFER_SRGB);
}

Picture FrameTarget::read() const
{
    Picture upside_down{width_, height_, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(width_);
    upside_down.rgba.resize(row * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.rgba.data());
    Picture picture = upside_down;
    for (int y = 0; y < height_; ++y)
        std::copy_n(upside_down.pixel(0, height_ - 1 - y), row,
                    picture.rgba.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y)));
    return picture;
}

void FrameTarget::show(int window_width, int window_height) const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, window_width, window_height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace kerf::render
