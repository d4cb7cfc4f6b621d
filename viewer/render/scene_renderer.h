#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>

#include "viewer/render/deferred_pass.h"
#include "viewer/render/frame_uniforms.h"
#include "viewer/render/shadow_map.h"
#include "viewer/render/surface_programs.h"
#include "viewer/render/swarm_pass.h"
#include "viewer/render/wall.h"

namespace kerf::render {

struct DrawOptions
{
    Lighting lighting = Lighting::textured;
    bool wireframe = false;  ///< edges of all triangles over the surfaces
    bool wall = true;        ///< false: objects before black
    /// Surfaces of small triangles are shaded once a pixel (DeferredPass). false: all are shaded while they are drawn,
    /// which looks the same.
    bool deferred = true;
    Lights lights;
    /// A plane (normal, then what is added) of the world: of objects that are clipped what lies beyond it is not drawn,
    /// and throws no shadow.
    glm::vec4 clip{0.0f};
};

/// Draws objects before the wall: shadows, surfaces, edges. Draws into whatever framebuffer part the caller names, so
/// that several pictures fit side by side.
class SceneRenderer
{
public:
    /// @throws RenderError
    explicit SceneRenderer(const LookTable& looks);

    /// Where on the target a picture goes, in pixels from the lower left corner.
    struct Area
    {
        int x = 0, y = 0, width = 1, height = 1;
    };

    /// Draws the shadow map, then the picture into `area` of the framebuffer that is bound now; the area's colour and
    /// depth are cleared first. Afterwards FrameUniforms are set for overlays on the same picture.
    void draw(const Viewpoint& viewpoint, std::span<const DrawnObject> objects, const DrawOptions& options,
              const Area& area);

    /// Makes a pattern's program unless there is one, so that the first object of its kind does not wait for it.
    /// @throws RenderError
    void warm_up(Pattern pattern);

    /// Of the last draw().
    const DrawStatistics& statistics() const { return statistics_; }

private:
    void draw_shadows(std::span<const DrawnObject> objects, const glm::mat4& projection, const glm::vec4& clip);
    void draw_surfaces(std::span<const DrawnObject> objects, const glm::mat4& view_projection,
                       const DrawOptions& options, const PictureTarget& target);
    void draw_at_once(std::span<const SurfaceDraw> draws, Lighting lighting);
    void draw_edges(std::span<const DrawnObject> objects);

    const LookTable& looks_;
    FrameUniforms uniforms_;
    ShadowMap shadow_map_;
    Wall wall_;
    SurfacePrograms programs_;
    DeferredPass deferred_;
    SwarmPass swarms_;
    ShaderProgram depth_, wire_;
    DrawStatistics statistics_;
};

}  // namespace kerf::render
