#pragma once

#include <optional>
#include <span>

#include "viewer/render/geometry_buffer.h"
#include "viewer/render/screen_rectangle.h"
#include "viewer/render/surface_programs.h"

namespace kerf::render {

/// The framebuffer, and the part of it, that a picture is drawn into.
struct PictureTarget
{
    GLuint framebuffer = 0;
    int samples = 0;  ///< 0: one, and no multisampling
    int x = 0, y = 0, width = 1, height = 1;
};

/// Something that is drawn, and where on the picture.
struct PlacedDraw
{
    SurfaceDraw surface;
    ScreenRectangle rectangle;
};

/// Draws surfaces of many small triangles: first what is seen where, then what that looks like, once a pixel, however
/// many triangles are in it or behind it. Twice where an outline of a surface lies before the same surface.
class DeferredPass
{
public:
    /// As many as the geometry buffer can number.
    static constexpr std::size_t kMostDraws = 2000;

    /// @throws RenderError
    DeferredPass();

    /// Whether the graphics card can.
    bool is_offered() const { return is_offered_; }

    /// Whether surfaces of this kind can be drawn on this target, and come cheaper so.
    bool suits(const PlacedDraw& draw, Pattern pattern, Lighting lighting, const PictureTarget& target) const;

    /// Finds out what is seen where.
    /// @param draws  at most kMostDraws that the pass suits
    /// @throws RenderError
    void fill(std::span<const PlacedDraw> draws, const PictureTarget& target, DrawStatistics& statistics);

    /// Shades what fill() found onto a target on which nothing is yet, and gives it its depth. FrameUniforms must be
    /// set and the shadow map bound. The target is bound afterwards.
    /// @throws RenderError
    void shade(std::span<const PlacedDraw> draws, Lighting lighting, const PictureTarget& target,
               SurfacePrograms& programs) const;

private:
    bool is_offered_;
    ShaderProgram program_;
    GlVertexArray nothing_;  ///< corners come from the vertex number
    std::optional<GeometryBuffer> buffer_;
};

}  // namespace kerf::render
