#pragma once

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "viewer/render/gl_objects.h"

namespace kerf::render {

/// From where a picture is taken.
struct Viewpoint
{
    glm::mat4 view{1.0f};
    glm::mat4 projection{1.0f};
    glm::vec3 eye{0.0f};
};

/// The room's light. Colours are linear.
struct Lights
{
    glm::vec3 to_light = glm::normalize(glm::vec3(-0.52f, 0.72f, 0.78f));  ///< unit, towards the key light
    glm::vec3 key{2.6f, 2.36f, 2.02f};
    glm::vec3 sky{0.50f, 0.56f, 0.66f};      ///< ambient from above
    glm::vec3 ground{0.33f, 0.285f, 0.25f};  ///< ambient from below
    float shadow = 0.86f;                    ///< how much of the key light a shadow takes, 0 to 1
    float exposure = 0.62f;
};

/// Frame in shaders/frame.glsl, laid out as std140 wants it.
struct FrameBlock
{
    glm::mat4 view_projection{1.0f};
    glm::mat4 shadow_transform{1.0f};
    glm::vec4 eye{0.0f};
    glm::vec4 to_light{0.0f};
    glm::vec4 light_colour{0.0f};
    glm::vec4 sky_colour{0.0f};
    glm::vec4 ground_colour{0.0f};
    glm::vec4 viewport{1.0f};
    glm::mat4 to_world{1.0f};
    glm::vec4 picture{0.0f};
    glm::vec4 clip{0.0f};
};

/// The uniform buffer that all programs of a frame read.
class FrameUniforms
{
public:
    FrameUniforms();
    void set(const FrameBlock& block);

private:
    GlBuffer buffer_;
};

}  // namespace kerf::render
