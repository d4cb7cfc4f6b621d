#pragma once

#include <optional>

#include "viewer/app/drawn_world.h"
#include "viewer/app/view_settings.h"
#include "viewer/render/frame_target.h"
#include "viewer/render/overlay.h"

namespace kerf::app {

/// Paints a simulation: objects, wall, proxies and blade. Needs a current GL context.
class Painter
{
public:
    /// @throws render::RenderError
    Painter(int width, int height);

    /// Makes the shader programs that these models and their insides need, so that no throw waits for one.
    /// @throws render::RenderError
    void warm_up(const sim::ModelShelf& models);

    /// Makes the picture larger or smaller. @throws render::RenderError
    void resize(int width, int height);

    /// Uploads what is new, without drawing.
    void sync(const sim::Simulation& simulation) { world_.sync(simulation); }

    /// Submits everything for one picture; afterwards the resolved picture is the target, for the panel.
    /// @param fraction  of the tick that is under way, for smooth movement between ticks
    void paint(const sim::Simulation& simulation, const ViewSettings& settings, double fraction = 1.0);

    const render::FrameTarget& target() const { return target_; }
    const DrawnWorld& world() const { return world_; }
    const render::DrawStatistics& statistics() const { return renderer_.statistics(); }

private:
    void paint_proxies(const sim::Simulation& simulation, double fraction);
    void paint_blade(const sim::Simulation& simulation, const ViewSettings& settings);

    render::LookTable looks_;
    DrawnWorld world_;
    render::SceneRenderer renderer_;
    render::Overlay overlay_;
    render::FrameTarget target_;
};

}  // namespace kerf::app
