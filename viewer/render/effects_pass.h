#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "viewer/render/shader_program.h"

namespace kerf::render {

/// A small thing that flies: drawn as a disc that faces the eye, stretched along its way. Laid out as the shader reads
/// it.
struct FlyingSprite
{
    enum Kind : std::uint32_t
    {
        juice,  ///< wet, lit, a little translucent
        spark,  ///< glows
        smoke,
        mist,   ///< juice too fine to see its drops, or dust
        crumb,  ///< a chip with faces
    };

    glm::vec3 place{0.0f};    ///< world
    float size = 0.05f;       ///< radius, world units
    glm::vec2 stretch{0.0f};  ///< how far it reaches beyond its radius, world units in the plane of the screen
    float opacity = 1.0f;
    float kind = juice;
    glm::vec3 colour{1.0f};  ///< linear
};

/// A stain on the wall. Laid out as the shader reads it.
struct StainSprite
{
    glm::vec2 place{0.0f};   ///< world
    float size = 0.5f;       ///< radius, world units
    float run = 0.0f;        ///< how far the longest drip has run down, in sizes
    glm::vec3 colour{1.0f};  ///< linear
    float opacity = 1.0f;
    float shape = 0.0f;  ///< 0 to 1: which shape, turned which way
    float wet = 1.0f;    ///< 1: it mirrors the lamp, 0: dry
};

/// Draws juice, sparks, smoke and stains over a picture right after SceneRenderer::draw(), with the FrameUniforms that
/// it has set; objects hide what is behind them. Two draw calls, however many there are.
class EffectsPass
{
public:
    /// @throws RenderError
    EffectsPass();

    void draw(std::span<const StainSprite> stains, std::span<const FlyingSprite> flying);

private:
    ShaderProgram stain_, flying_;
    GlTexture splats_;
    GlBuffer stain_instances_, flying_instances_;
    GlVertexArray stain_array_, flying_array_;
};

}  // namespace kerf::render
