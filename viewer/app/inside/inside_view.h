#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/view_settings.h"
#include "viewer/inside/study.h"
#include "viewer/render/fragment_store.h"
#include "viewer/render/frame_target.h"
#include "viewer/render/overlay.h"
#include "viewer/render/scene_renderer.h"
#include "viewer/render/section_cap.h"
#include "viewer/sim/camera.h"

namespace kerf::app {

/// Paints a model that is looked into: what lies behind the plane, its cap, the outline and the contours. Needs a
/// current GL context.
class InsideView
{
public:
    /// @throws render::RenderError
    InsideView(int width, int height);

    /// Makes the picture larger or smaller. @throws render::RenderError
    void resize(int width, int height);
    /// Another model comes: what is on the graphics card of the last one goes.
    void forget();
    /// Brings onto the graphics card what has changed of the study.
    /// @param images  of the model's materials
    /// @throws render::RenderError
    void sync(inside::Study& study, std::span<const std::string> images, bool has_moved);
    /// Afterwards the picture is the target, for the panel.
    void paint(const inside::Study& study, bool is_closed, const ViewSettings& settings);

    /// Of the last section that was brought: processor time of this thread.
    double upload_cpu_ms() const { return upload_cpu_ms_; }
    const render::FrameTarget& target() const { return target_; }
    std::vector<std::string> take_messages() { return looks_.take_messages(); }

    /// How far the plane goes, in half diagonals of the model, if the pointer goes from one place of the stage to
    /// another.
    static double way_of(const inside::MovingPlane& plane, const glm::dvec2& from, const glm::dvec2& to);

private:
    void list_lines(const inside::Study& study);

    render::LookTable looks_;
    render::FragmentStore store_;
    render::SceneRenderer renderer_;
    render::Overlay overlay_;
    render::FrameTarget target_;
    std::optional<render::DrawnFragment> model_;
    render::SectionCap cap_;
    std::vector<glm::vec3> outline_, contours_;  ///< ends of lines, world
    double upload_cpu_ms_ = 0.0;
};

}  // namespace kerf::app
