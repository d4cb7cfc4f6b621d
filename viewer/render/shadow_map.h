#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "viewer/render/gl_objects.h"

namespace kerf::render {

/// Depth seen from the key light, over a ball that holds everything that throws or catches a shadow.
class ShadowMap
{
public:
    static constexpr int kSize = 1024;

    ShadowMap();

    /// From now on drawing fills the map.
    void begin() const;

    GLuint texture() const { return depth_.id(); }

    /// World to the light's clip space, for a ball around the origin.
    static glm::mat4 projection(const glm::vec3& to_light, float radius);
    /// The same to texture coordinates and depth, 0 to 1.
    static glm::mat4 lookup(const glm::mat4& projection);
    /// Size of a texel in the world.
    static float texel(float radius) { return 2.0f * radius / static_cast<float>(kSize); }

private:
    GlTexture depth_;
    GlFramebuffer framebuffer_;
};

}  // namespace kerf::render
