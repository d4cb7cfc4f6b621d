#pragma once

#include "viewer/render/gl_objects.h"
#include "viewer/render/shader_program.h"

namespace kerf::render {

/// The plastered wall behind the stage. Its relief is drawn once, by a shader, into a texture.
class Wall
{
public:
    static constexpr float kZ = -2.6f;          ///< where it stands, world units
    static constexpr float kHalfWidth = 40.0f;  ///< beyond what any window sees
    static constexpr float kHalfHeight = 24.0f;
    static constexpr float kLightRadius = 6.5f;  ///< the pool of the lamp's light

    /// @throws RenderError
    Wall();

    /// Draws it, with FrameUniforms set and the shadow map bound to texture unit 0.
    void draw() const;

private:
    GlTexture relief_, grain_;
    GlVertexArray nothing_;  ///< the corners come from the vertex number
    ShaderProgram program_;
};

}  // namespace kerf::render
