#pragma once

#include "viewer/render/gl_objects.h"

namespace kerf::render {

/// What is seen at each sample of a picture, before anybody knows what it looks like: the surface's normal, the number
/// of the batch that it belongs to, its depth.
class GeometryBuffer
{
public:
    /// @throws RenderError
    GeometryBuffer(int width, int height, int samples);

    bool is_for(int width, int height, int samples) const
    {
        return width == width_ && height == height_ && samples == samples_;
    }

    /// From now on drawing fills the buffer; nothing is in it. geometry.frag writes what it takes.
    void begin() const;

    /// Copies its depth into a framebuffer of as many samples, with the lower left corner there. That framebuffer is
    /// bound afterwards.
    void copy_depth_to(GLuint framebuffer, int x, int y) const;

    void bind_textures(GLint surfaces_unit, GLint depth_unit) const;

private:
    int width_, height_, samples_;
    GlTexture surfaces_;  ///< normal in the world, of no certain length, towards the eye; number of the batch
    GlTexture depth_;
    GlFramebuffer framebuffer_;
};

}  // namespace kerf::render
