#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <span>
#include <string_view>

#include "viewer/render/fragment_store.h"
#include "viewer/render/frame_uniforms.h"
#include "viewer/render/shader_program.h"
#include "viewer/render/shadow_map.h"
#include "viewer/render/wall.h"

namespace kerf::render {

enum class Lighting : std::uint8_t
{
    lambert,   ///< the report's: a colour, a light, the cosine between
    textured,  ///< patterns in object space and cap uv, highlights, the light of the room
};

/// One object of a frame.
struct DrawnObject
{
    std::uint32_t id = 0;  ///< what the inspection pass writes; 0 is the background's
    const DrawnFragment* fragment = nullptr;
    glm::mat4 model{1.0f};  ///< mesh coordinates to world: turned, moved, scaled alike in all directions; no mirror
    float pattern_scale = 1.0f;  ///< 1 / size of the object before any cut, so that patterns stay where they are
    /// Cut from a mesh without boundary. Of such an object only what faces the eye is drawn: its back is never seen,
    /// and where caps lie on one another, facing either way, rounding must not choose between them.
    bool is_closed = false;
};

/// From now on what faces away is left out, if the object is closed.
void cull_for(const DrawnObject& object);

struct DrawOptions
{
    Lighting lighting = Lighting::textured;
    bool wireframe = false;  ///< edges of all triangles over the surfaces
    bool wall = true;        ///< false: objects before black
    Lights lights;
};

/// What a frame cost in commands.
struct DrawStatistics
{
    std::uint64_t calls = 0;   ///< glMultiDrawElements
    std::uint64_t ranges = 0;  ///< in all of them
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
    void warm_up(Pattern pattern) { textured(pattern); }

    /// Of the last draw().
    const DrawStatistics& statistics() const { return statistics_; }

private:
    struct SurfaceProgram
    {
        ShaderProgram program;
        GLint model, pattern_scale, look_index, is_cap;

        explicit SurfaceProgram(ShaderProgram linked);
    };

    void draw_shadows(std::span<const DrawnObject> objects, const glm::mat4& projection);
    void draw_surfaces(std::span<const DrawnObject> objects, Lighting lighting);
    const SurfaceProgram& textured(Pattern pattern);
    void draw_edges(std::span<const DrawnObject> objects);
    void draw_runs(const IndexRuns& runs);

    const LookTable& looks_;
    FrameUniforms uniforms_;
    ShadowMap shadow_map_;
    Wall wall_;
    SurfaceProgram lambert_;
    std::map<const std::string_view*, SurfaceProgram> textured_;  ///< by the place of shaders_of(pattern)
    ShaderProgram depth_, wire_;
    DrawStatistics statistics_;
};

}  // namespace kerf::render
