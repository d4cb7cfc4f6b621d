#include "viewer/app/painter.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <set>
#include <vector>

#include "viewer/app/proxy_lines.h"
#include "viewer/render/rehearsal.h"
#include "viewer/render/wall.h"
#include "viewer/sim/camera.h"

namespace kerf::app {

namespace {

/// Of the blade, in heights of the picture.
constexpr float kBladeWidth = 0.022f;

constexpr glm::vec4 kProxyColour{0.25f, 1.0f, 0.55f, 0.85f};

sim::Camera camera_for(const render::SceneRenderer::Area& area)
{
    return sim::Camera(double(area.width) / double(area.height));
}

/// Clip space to clip space: what ViewSettings say about enlarging.
glm::mat4 enlargement(const sim::Camera& camera, const ViewSettings& settings)
{
    if (settings.zoom == 1.0f) return glm::mat4(1.0f);
    const glm::vec3 middle(camera.world_to_ndc({settings.zoom_at.x, settings.zoom_at.y, 0.0}));
    const glm::mat4 larger = glm::scale(glm::mat4(1.0f), glm::vec3(settings.zoom, settings.zoom, 1.0f));
    return glm::translate(larger, glm::vec3(-middle.x, -middle.y, 0.0f));
}

/// The same for a camera that trembles.
glm::mat4 shaken(const sim::Camera& camera, const effects::Effects* effects)
{
    if (effects == nullptr || effects->shake().at_rest()) return glm::mat4(1.0f);
    const glm::dvec3 offset(glm::dvec2(effects->shake().offset()), 0.0);
    const glm::vec2 moved(camera.world_to_ndc(offset) - camera.world_to_ndc(glm::dvec3(0.0)));
    return glm::translate(glm::mat4(1.0f), glm::vec3(moved, 0.0f));
}

static_assert(effects::kWallZ == render::Wall::kZ, "juice ends on the wall that is drawn");

render::StainSprite sprite_of(const effects::Stain& stain)
{
    return {stain.place,    stain.size * stain.spread(), stain.run(), stain.colour, stain.opacity(), stain.shape,
            stain.wetness()};
}

render::FlyingSprite sprite_of(const effects::Drop& drop)
{
    constexpr float kExposure = 0.018f;  // seconds: what moves is drawn as long as its way in this time
    render::FlyingSprite sprite;
    sprite.place = drop.place;
    sprite.size = drop.size;
    sprite.colour = drop.colour;
    switch (drop.kind) {
        case effects::DropKind::juice:
            sprite.kind = render::FlyingSprite::juice;
            sprite.stretch = kExposure * glm::vec2(drop.velocity);
            sprite.opacity = std::min(4.0f * drop.left(), 1.0f);
            break;
        case effects::DropKind::spark:
            sprite.kind = render::FlyingSprite::spark;
            sprite.stretch = 1.5f * kExposure * glm::vec2(drop.velocity);
            sprite.opacity = drop.left();
            break;
        case effects::DropKind::smoke:
            sprite.kind = render::FlyingSprite::smoke;
            sprite.opacity = drop.left();
            break;
        case effects::DropKind::mist:
            sprite.kind = render::FlyingSprite::mist;
            sprite.opacity = 0.34f * drop.left() * drop.left();
            break;
        case effects::DropKind::crumb:
            sprite.kind = render::FlyingSprite::crumb;
            sprite.opacity = std::min(6.0f * drop.left(), 1.0f);
            break;
    }
    return sprite;
}

/// Looks of one pattern are drawn with one program: the first of each.
std::vector<std::uint32_t> one_of_each_pattern(const render::LookTable& table, const std::vector<std::uint32_t>& looks)
{
    std::vector<std::uint32_t> chosen;
    std::set<render::Pattern> seen;
    for (const std::uint32_t look : looks)
        if (seen.insert(table.look(look).pattern).second) chosen.push_back(look);
    return chosen;
}

}  // namespace

Painter::Painter(int width, int height) : world_(std::in_place, looks_), renderer_(looks_), target_(width, height) {}

void Painter::warm_up(const sim::ModelLibrary& models, std::size_t most_pieces)
{
    std::vector<std::uint32_t> surfaces, caps;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const sim::Model& model = models.model(i);
        std::vector<Material> materials;
        for (std::size_t m = 0; m < model.mesh.material_count(); ++m) {
            materials.push_back(model.mesh.material(m));
            if (m < model.images.size()) materials.back().base_colour_image = model.images[m].c_str();
        }
        materials.push_back({"cap"});
        for (std::uint32_t m = 0; m < materials.size(); ++m) {
            if (*materials[m].base_colour_image != '\0')
                renderer_.warm_up(looks_.look(looks_.index_of(materials, m, TriangleKind::surface)).pattern);
            for (const TriangleKind kind : {TriangleKind::surface, TriangleKind::cap}) {
                renderer_.warm_up(render::look_of(materials, m, kind).pattern);
                (kind == TriangleKind::cap ? caps : surfaces).push_back(looks_.index_of(materials, m, kind));
            }
        }
    }
    rehearse(one_of_each_pattern(looks_, surfaces), one_of_each_pattern(looks_, caps), most_pieces);
}

/// Draws with everything once, into a picture that nobody sees.
void Painter::rehearse(const std::vector<std::uint32_t>& surfaces, const std::vector<std::uint32_t>& caps,
                       std::size_t most_pieces)
{
    const render::Rehearsal rehearsal(surfaces, caps, most_pieces);
    StagePicture stage;
    stage.objects = rehearsal.objects();
    stage.area = whole();
    paint(std::span(&stage, 1), {});
    const render::StainSprite stain{};
    const render::FlyingSprite drop{};
    target_.bind();
    effects_pass_.draw(std::span(&stain, 1), std::span(&drop, 1));
}

void Painter::resize(int width, int height)
{
    if (std::max(width, 1) == target_.width() && std::max(height, 1) == target_.height()) return;
    target_ = render::FrameTarget(width, height);
}

void Painter::paint(const sim::Simulation& simulation, const ViewSettings& settings, double fraction,
                    const effects::Effects* effects, const sim::Blade* blade)
{
    std::vector<glm::vec3> lines;
    if (settings.proxies)
        for (const auto& body : simulation.bodies())
            append_proxy_lines(body->proxy().proxy(), glm::mat4(body->model_matrix(fraction)), lines);
    const StagePicture stage{world_->objects(simulation, fraction),
                             blade != nullptr ? blade : &simulation.blade(),
                             simulation.time(),
                             effects,
                             lines,
                             whole()};
    paint(std::span(&stage, 1), settings);
}

void Painter::paint(std::span<const StagePicture> stages, const ViewSettings& settings)
{
    target_.bind();
    for (const StagePicture& stage : stages) paint_stage(stage, settings);
    target_.resolve();
}

void Painter::paint_stage(const StagePicture& stage, const ViewSettings& settings)
{
    const sim::Camera camera = camera_for(stage.area);
    const glm::mat4 to_picture = shaken(camera, stage.effects) * enlargement(camera, settings);
    render::Viewpoint viewpoint;
    viewpoint.view = glm::mat4(camera.view());
    viewpoint.projection = to_picture * glm::mat4(camera.projection());
    viewpoint.eye = glm::vec3(camera.eye());
    render::DrawOptions options;
    options.lighting = settings.lighting;
    options.wireframe = settings.wireframe;
    renderer_.draw(viewpoint, stage.objects, options, stage.area);
    if (stage.effects != nullptr) paint_effects(*stage.effects);
    overlay_.draw_lines(stage.lines, kProxyColour);
    paint_blade(stage, to_picture);
}

void Painter::paint_effects(const effects::Effects& effects)
{
    std::vector<render::StainSprite> stains;
    for (const effects::Stain& stain : effects.stains().all()) stains.push_back(sprite_of(stain));
    std::vector<render::FlyingSprite> flying;
    for (const effects::Drop& drop : effects.drops().all()) flying.push_back(sprite_of(drop));
    effects_pass_.draw(stains, flying);
}

void Painter::paint_blade(const StagePicture& stage, const glm::mat4& to_picture)
{
    if (stage.blade == nullptr) return;
    const sim::Camera camera = camera_for(stage.area);
    const glm::vec2 size(stage.area.width, stage.area.height);
    std::vector<render::BladePoint> path;
    std::uint32_t swipe = 0;
    const auto draw = [&] {
        const auto ribbon = render::blade_ribbon(path, kBladeWidth * size.y);
        overlay_.draw_blade(ribbon, size.x, size.y);
        path.clear();
    };
    for (const sim::TrailPoint& point : stage.blade->trail(stage.now)) {
        if (point.swipe != swipe) draw();
        swipe = point.swipe;
        const glm::vec4 ndc(camera.world_to_ndc({point.position, 0.0}), 1.0);
        const glm::vec2 place(to_picture * ndc);
        const double age = double(stage.now - point.time) / double(sim::kTrail);
        const bool fades = stage.blade->gesture() == sim::Gesture::blade;
        path.push_back(
            {0.5f * (place + 1.0f) * size, fades ? static_cast<float>(std::clamp(1.0 - age, 0.0, 1.0)) : 1.0f});
    }
    draw();
}

}  // namespace kerf::app
