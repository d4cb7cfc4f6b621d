#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/render/scene_renderer.h"

namespace kerf::render {

/// What is seen through one pixel.
struct PixelFacts
{
    std::uint32_t object = 0;  ///< DrawnObject::id; 0: background
    std::uint32_t kind = 0;    ///< 1 + TriangleKind; 0: background
    glm::vec3 place{0.0f};     ///< mesh coordinates, times pattern_scale
    float depth = 1.0f;
    glm::vec2 uv{0.0f};

    bool is_cap() const { return kind == 1u + static_cast<std::uint32_t>(TriangleKind::cap); }
};

/// Draws what is where instead of what it looks like: object, surface or cap, place on the object, uv. With the vertex
/// shader of the picture, one sample a pixel. For picking, and for tests that look at pictures.
class InspectionPass
{
public:
    /// @throws RenderError
    InspectionPass(int width, int height);

    /// Rows from the top. Waits for the graphics card.
    std::vector<PixelFacts> draw(const Viewpoint& viewpoint, std::span<const DrawnObject> objects);

private:
    int width_, height_;
    FrameUniforms uniforms_;
    ShaderProgram program_;
    GlTexture ids_, places_, uvs_, depth_;
    GlFramebuffer framebuffer_;
};

}  // namespace kerf::render
