#include "viewer/app/painter.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <vector>

#include "viewer/render/proxy_lines.h"
#include "viewer/sim/camera.h"

namespace kerf::app {

namespace {

/// Of the blade, in heights of the picture.
constexpr float kBladeWidth = 0.022f;

constexpr glm::vec4 kProxyColour{0.25f, 1.0f, 0.55f, 0.85f};

sim::Camera camera_for(const render::FrameTarget& target)
{
    return sim::Camera(double(target.width()) / double(target.height()));
}

/// Clip space to clip space: what ViewSettings say about enlarging.
glm::mat4 enlargement(const sim::Camera& camera, const ViewSettings& settings)
{
    if (settings.zoom == 1.0f) return glm::mat4(1.0f);
    const glm::vec3 middle(camera.world_to_ndc({settings.zoom_at.x, settings.zoom_at.y, 0.0}));
    const glm::mat4 larger = glm::scale(glm::mat4(1.0f), glm::vec3(settings.zoom, settings.zoom, 1.0f));
    return glm::translate(larger, glm::vec3(-middle.x, -middle.y, 0.0f));
}

}  // namespace

Painter::Painter(int width, int height) : world_(looks_), renderer_(looks_), target_(width, height) {}

void Painter::warm_up(const sim::ModelShelf& models)
{
    for (std::size_t i = 0; i < models.size(); ++i) {
        std::vector<Material> materials = models.model(i).mesh.materials;
        add_cap_material(materials);
        for (std::uint32_t m = 0; m < materials.size(); ++m)
            for (const TriangleKind kind : {TriangleKind::surface, TriangleKind::cap})
                renderer_.warm_up(render::look_of(materials, m, kind).pattern);
    }
}

void Painter::resize(int width, int height)
{
    if (std::max(width, 1) == target_.width() && std::max(height, 1) == target_.height()) return;
    target_ = render::FrameTarget(width, height);
}

void Painter::paint(const sim::Simulation& simulation, const ViewSettings& settings, double fraction)
{
    const sim::Camera camera = camera_for(target_);
    render::Viewpoint viewpoint;
    viewpoint.view = glm::mat4(camera.view());
    viewpoint.projection = enlargement(camera, settings) * glm::mat4(camera.projection());
    viewpoint.eye = glm::vec3(camera.eye());
    render::DrawOptions options;
    options.lighting = settings.lighting;
    options.wireframe = settings.wireframe;

    target_.bind();
    renderer_.draw(viewpoint, world_.objects(simulation, fraction), options, {0, 0, target_.width(), target_.height()});
    if (settings.proxies) paint_proxies(simulation, fraction);
    paint_blade(simulation, settings);
    target_.resolve();
}

void Painter::paint_proxies(const sim::Simulation& simulation, double fraction)
{
    std::vector<glm::vec3> lines;
    for (const auto& body : simulation.bodies())
        render::append_proxy_lines(body->proxy().proxy(), glm::mat4(body->model_matrix(fraction)), lines);
    overlay_.draw_lines(lines, kProxyColour);
}

void Painter::paint_blade(const sim::Simulation& simulation, const ViewSettings& settings)
{
    const sim::Camera camera = camera_for(target_);
    const glm::mat4 to_picture = enlargement(camera, settings);
    const glm::vec2 size(target_.width(), target_.height());
    const sim::Microseconds now = simulation.time();
    std::vector<render::BladePoint> path;
    std::uint32_t swipe = 0;
    const auto draw = [&] {
        const auto ribbon = render::blade_ribbon(path, kBladeWidth * size.y);
        overlay_.draw_blade(ribbon, size.x, size.y);
        path.clear();
    };
    for (const sim::TrailPoint& point : simulation.blade().trail(now)) {
        if (point.swipe != swipe) draw();
        swipe = point.swipe;
        const glm::vec4 ndc(camera.world_to_ndc({point.position, 0.0}), 1.0);
        const glm::vec2 place(to_picture * ndc);
        const double age = double(now - point.time) / double(sim::kTrail);
        const bool fades = simulation.blade().gesture() == sim::Gesture::blade;
        path.push_back(
            {0.5f * (place + 1.0f) * size, fades ? static_cast<float>(std::clamp(1.0 - age, 0.0, 1.0)) : 1.0f});
    }
    draw();
}

}  // namespace kerf::app
