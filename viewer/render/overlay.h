#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "viewer/render/blade_ribbon.h"
#include "viewer/render/shader_program.h"

namespace kerf::render {

/// What is drawn over a picture right after SceneRenderer::draw(): lines in the world, and the blade on the screen.
class Overlay
{
public:
    /// @throws RenderError
    Overlay();

    /// Lines between pairs of points, in world coordinates; hidden ones show faintly.
    void draw_lines(std::span<const glm::vec3> points, const glm::vec4& colour);

    /// A ribbon from blade_ribbon(), in pixels of an area of this size from its lower left corner.
    void draw_blade(std::span<const RibbonVertex> ribbon, float width, float height);

private:
    ShaderProgram line_, blade_;
    GlBuffer line_vertices_, blade_vertices_;
    GlVertexArray line_array_, blade_array_;
};

}  // namespace kerf::render
