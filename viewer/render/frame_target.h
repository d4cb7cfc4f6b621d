#pragma once

#include "viewer/render/gl_objects.h"
#include "viewer/render/picture.h"

namespace kerf::render {

/// What a frame is drawn into: sRGB colour and depth, several samples a pixel, and the picture that they become.
class FrameTarget
{
public:
    static constexpr int kSamples = 4;

    /// Sizes below 1 become 1: a minimised window has no area. @throws RenderError
    FrameTarget(int width, int height, int samples = kSamples);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Makes this the target of drawing; linear colours are turned into sRGB on the way.
    void bind() const;

    /// Joins the samples into the picture, and makes that the target: what is drawn now (the panel) is in sRGB already.
    void resolve() const;

    /// The resolved picture. Waits for the graphics card.
    Picture read() const;

    /// Puts the resolved picture into the window's framebuffer.
    void show(int window_width, int window_height) const;

private:
    int width_, height_;
    GlRenderbuffer colour_, depth_;
    GlFramebuffer samples_;
    GlTexture picture_;
    GlFramebuffer resolved_;
};

}  // namespace kerf::render
