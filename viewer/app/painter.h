#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/app/gpu_world.h"
#include "viewer/app/view_settings.h"
#include "viewer/effects/effects.h"
#include "viewer/render/effects_pass.h"
#include "viewer/render/frame_target.h"
#include "viewer/render/overlay.h"

namespace kerf::app {

/// One stage, and where on the picture it is seen.
struct StagePicture
{
    std::span<const render::DrawnObject> objects;
    const sim::Blade* blade = nullptr;          ///< null: none
    sim::Microseconds now = 0;                  ///< of the blade
    const effects::Effects* effects = nullptr;  ///< null: none
    std::span<const glm::vec3> lines = {};      ///< collision proxies: ends of lines, world
    render::SceneRenderer::Area area;           ///< pixels from the lower left corner
};

/// Paints simulations: objects, wall, proxies, effects and blade. Needs a current GL context.
class Painter
{
public:
    /// @throws render::RenderError
    Painter(int width, int height);

    /// Makes the shader programs that these models and their insides need, draws with each once, and reads their images,
    /// so that no throw and nothing that breaks waits for one.
    /// @param most_pieces  Scene::most_pieces()
    /// @throws render::RenderError
    void warm_up(const sim::ModelLibrary& models, std::size_t most_pieces);

    /// Makes the picture larger or smaller. @throws render::RenderError
    void resize(int width, int height);

    /// Uploads what is new, without drawing.
    void sync(const sim::Simulation& simulation) { world_->sync(simulation); }
    /// For another simulation: frees what is on the graphics card of the last one.
    void forget_world() { world_.emplace(looks_); }

    /// Submits everything for one picture; afterwards the resolved picture is the target, for the panel.
    /// @param fraction  of the tick that is under way, for smooth movement between ticks
    /// @param effects   of the simulation; null: none
    /// @param blade     that is shown; null: the simulation's own
    void paint(const sim::Simulation& simulation, const ViewSettings& settings, double fraction = 1.0,
               const effects::Effects* effects = nullptr, const sim::Blade* blade = nullptr);

    /// The same for several stages on one picture.
    void paint(std::span<const StagePicture> stages, const ViewSettings& settings);
    render::LookTable& looks() { return looks_; }
    render::SceneRenderer::Area whole() const { return {0, 0, target_.width(), target_.height()}; }

    /// Of images that can't be used, one sentence each. Cleared by reading.
    std::vector<std::string> take_messages() { return looks_.take_messages(); }

    const render::FrameTarget& target() const { return target_; }
    const GpuWorld& world() const { return *world_; }
    const render::DrawStatistics& statistics() const { return renderer_.statistics(); }

private:
    void rehearse(const std::vector<std::uint32_t>& surfaces, const std::vector<std::uint32_t>& caps,
                  std::size_t most_pieces);
    void paint_stage(const StagePicture& stage, const ViewSettings& settings);
    void paint_effects(const effects::Effects& effects);
    void paint_blade(const StagePicture& stage, const glm::mat4& to_picture);

    render::LookTable looks_;
    std::optional<GpuWorld> world_;  ///< never empty
    render::SceneRenderer renderer_;
    render::EffectsPass effects_pass_;
    render::Overlay overlay_;
    render::FrameTarget target_;
};

}  // namespace kerf::app
