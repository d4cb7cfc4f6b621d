#include "viewer/effects/effects.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "viewer/sim/camera.h"
#include "viewer/sim/kerf_glm.h"

namespace kerf::effects {

namespace {

/// Points of a section that are looked at: enough to show its shape.
constexpr std::size_t kOutlinePoints = 96;
constexpr float kFlashFades = 2.2f;  // of the flash in a second
constexpr float kSlowScale = 0.35f;
constexpr glm::vec3 kDust{0.46f, 0.43f, 0.39f}, kIceDust{0.72f, 0.84f, 0.95f};  // linear
constexpr float kSmallestStain = 0.025f;                                        // radius of the drop, world units

// sRGB, as text is drawn.
constexpr glm::vec3 kWhite{1.0f, 0.98f, 0.92f}, kGold{1.0f, 0.82f, 0.25f}, kRed{1.0f, 0.28f, 0.22f},
    kIce{0.55f, 0.86f, 1.0f}, kOrange{1.0f, 0.58f, 0.2f}, kViolet{0.86f, 0.62f, 1.0f}, kGreen{0.55f, 0.95f, 0.45f};

const game::Fruit* fruit_of_model(const std::string& model)
{
    for (const game::Fruit& fruit : game::fruit_catalogue())
        if (fruit.model == model) return &fruit;
    return nullptr;
}

/// Every n-th point of all loops, in the world.
std::vector<glm::vec3> outline_of(const sim::Body& piece)
{
    const Object& object = piece.object();
    std::size_t points = 0;
    for (std::size_t l = 0; l < object.loop_count(); ++l) points += object.loop(l).points.size();
    const std::size_t stride = std::max<std::size_t>(1, points / kOutlinePoints);
    const sim::MeshPose pose = piece.pose();
    std::vector<glm::vec3> outline;
    std::size_t i = 0;
    for (std::size_t l = 0; l < object.loop_count(); ++l)
        for (const Vec3f& point : object.loop(l).points)
            if (i++ % stride == 0) outline.emplace_back(pose.to_world(glm::dvec3(glm::vec3(point))));
    return outline;
}

std::string signed_number(std::int64_t points)
{
    std::string text = std::to_string(points);
    if (points >= 0) text.insert(text.begin(), '+');
    return text;
}

/// Inside the stage, so that what is said there can be read.
glm::dvec2 within_view(const glm::dvec2& place)
{
    return glm::clamp(place, glm::dvec2(-0.86 * sim::kStageHalfWidth, -0.82 * sim::kStageHalfHeight),
                      glm::dvec2(0.86 * sim::kStageHalfWidth, 0.72 * sim::kStageHalfHeight));
}

}  // namespace

double Effects::time_scale() const
{
    return slowed_ > 0.0f ? double(kSlowScale) : 1.0;
}

void Effects::follow(const sim::Simulation& simulation)
{
    const std::vector<sim::CutRecord>& cuts = simulation.cuts();
    for (; cuts_seen_ < cuts.size(); ++cuts_seen_) take_cut(simulation, cuts[cuts_seen_]);
    for (; breaks_seen_ < simulation.breaks().size(); ++breaks_seen_)
        take_break(simulation, simulation.breaks()[breaks_seen_]);
    for (; cracks_seen_ < simulation.cracks().size(); ++cracks_seen_)
        take_crack(simulation, simulation.cracks()[cracks_seen_]);
    if (const game::GameScene* const played = game::game_of(simulation.scene()))
        for (; events_seen_ < played->events().size(); ++events_seen_)
            take_event(played->events()[events_seen_], played->state().lives_at_start);
    for (; now_ < simulation.now(); ++now_) step(simulation);
}

void Effects::take_cut(const sim::Simulation& simulation, const sim::CutRecord& cut)
{
    if (cut.pieces.empty()) return;
    const game::Fruit* const fruit = fruit_of_model(simulation.models().model(cut.model).name);
    if (fruit == nullptr || fruit->kind == game::FruitKind::bomb) return;
    Splash splash;
    splash.seed = cut.number + 0x51CEu * simulation.settings().seed;
    splash.centre = glm::vec3(cut.centre);
    splash.normal = glm::vec3(cut.normal);
    splash.colour = fruit->juice;
    for (const sim::PieceRecord& record : cut.pieces) {
        // A piece may have been cut again in the same frame; any of them tells the section.
        const sim::Body* const piece = simulation.world().find(record.id);
        if (piece == nullptr) continue;
        if (splash.outline.empty()) splash.outline = outline_of(*piece);
        splash.velocity = glm::vec3(piece->motion().velocity);
    }
    if (!splash.outline.empty()) {
        glm::vec3 middle(0.0f);
        for (const glm::vec3& point : splash.outline) middle += point;
        splash.centre = middle / static_cast<float>(splash.outline.size());
        float farthest = 0.0f;
        for (const glm::vec3& point : splash.outline)
            farthest = std::max(farthest, glm::distance(point, splash.centre));
        splash.size = farthest;
    } else {
        splash.size = 0.5f * static_cast<float>(fruit->radius);
    }
    constexpr auto kEye = static_cast<float>(sim::kEyeDistance);
    splash.behind = glm::vec2(splash.centre) * (kEye - kWallZ) / (kEye - splash.centre.z);
    // A small section bleeds little.
    splash.strength = std::clamp(splash.size / 0.6f, 0.1f, 1.2f);
    add_splash(splash, drops_, stains_);
}

/// Fruit bleeds, what is frozen less, and in a cloud of ice; everything else is left to its cracks.
void Effects::take_break(const sim::Simulation& simulation, const sim::BreakRecord& broken)
{
    const game::Fruit* const fruit = fruit_of_model(simulation.models().model(broken.model).name);
    if (fruit == nullptr || broken.pieces.empty()) return;
    Splash splash;
    splash.seed = (broken.number << 20) + 0x51CEu * simulation.settings().seed;
    splash.centre = glm::vec3(broken.centre);
    splash.colour = fruit->juice;
    splash.size = 0.8f * static_cast<float>(broken.radius);
    if (const sim::Body* const piece = simulation.world().find(broken.pieces.front()))
        splash.velocity = glm::vec3(piece->motion().velocity);
    constexpr auto kEye = static_cast<float>(sim::kEyeDistance);
    splash.behind = glm::vec2(splash.centre) * (kEye - kWallZ) / (kEye - splash.centre.z);
    const bool is_frozen = fruit->kind == game::FruitKind::frozen;
    if (is_frozen) splash.strength = 0.4f;
    add_splash(splash, drops_, stains_);
    if (is_frozen) add_dust({splash.seed + 1, splash.centre, splash.velocity, kIceDust, splash.size, 1.0f}, drops_);
    shake_.hit(0.2f);
}

/// Dust where bonds broke, from all of an object that fell apart.
void Effects::take_crack(const sim::Simulation& simulation, const sim::CrackRecord& crack)
{
    if (crack.bonds == 0 || fruit_of_model(simulation.models().model(crack.model).name) != nullptr) return;
    // So many bonds are all that one sees.
    constexpr float kMany = 150.0f;
    Dust dust;
    dust.seed = std::uint64_t(crack.tick) * 131 + crack.bonds;
    dust.centre = glm::vec3(crack.place);
    dust.colour = kDust;
    dust.strength = std::sqrt(std::min(1.0f, static_cast<float>(crack.bonds) / kMany));
    dust.size = static_cast<float>(crack.radius) * (0.25f + 0.4f * dust.strength);
    add_dust(dust, drops_);
    shake_.hit(0.12f + 0.25f * dust.strength);
}

void Effects::say(const glm::dvec2& place, std::string text, const glm::vec3& colour, float size, float life)
{
    popups_.add({glm::vec2(within_view(place)), std::move(text), colour, size, life});
}

void Effects::take_event(const game::GameEvent& event, std::int64_t lives_at_start)
{
    const glm::vec3 centre(glm::vec2(event.place), 0.3f);
    switch (event.kind) {
        case game::GameEventKind::fruit_cut:
            if (event.points != 0) say(event.place, signed_number(event.points), kWhite, 0.8f, 0.8f);
            break;
        case game::GameEventKind::critical:
            say(event.place + glm::dvec2(0.0, 0.7), "Critical " + signed_number(event.points), kGold, 1.2f);
            add_sparkle(centre, {1.0f, 0.7f, 0.15f}, event.cut, drops_);
            shake_.hit(0.25f);
            slowed_ = 0.05f;
            break;
        case game::GameEventKind::combo:
            say(event.place, std::to_string(event.count) + " fruit combo\n" + signed_number(event.points), kOrange,
                1.7f, 1.5f);
            shake_.hit(0.3f);
            slowed_ = 0.08f;
            break;
        case game::GameEventKind::missed:
            if (lives_at_start > 0) say({event.place.x, -sim::kStageHalfHeight}, "miss", kRed, 1.0f);
            break;
        case game::GameEventKind::extra_life:
            say({0.0, 1.0}, "Extra life", kGreen, 1.6f, 1.6f);
            break;
        case game::GameEventKind::bomb:
            if (event.points < 0) say(event.place, signed_number(event.points), kRed, 1.8f, 1.6f);
            add_explosion(centre, event.cut, drops_);
            flash_ = 1.0f;
            shake_.hit(1.0f);
            slowed_ = 0.12f;
            break;
        case game::GameEventKind::special_started: {
            const bool freezes = event.fruit == game::FruitKind::freeze;
            const bool doubles = event.fruit == game::FruitKind::double_points;
            const bool smashes = event.fruit == game::FruitKind::hammer;
            say({0.0, 1.2},
                freezes   ? "Freeze"
                : doubles ? "Double points"
                : smashes ? "Hammer"
                          : "Frenzy",
                freezes   ? kIce
                : doubles ? kViolet
                : smashes ? kGreen
                          : kOrange,
                1.9f, 1.6f);
            add_sparkle(centre,
                        freezes   ? glm::vec3(0.3f, 0.7f, 1.0f)
                        : smashes ? glm::vec3(0.3f, 1.0f, 0.35f)
                                  : glm::vec3(1.0f, 0.5f, 0.2f),
                        event.cut, drops_);
            break;
        }
        case game::GameEventKind::wave:
        case game::GameEventKind::thrown:
        case game::GameEventKind::life_lost:
        case game::GameEventKind::special_ended:
        case game::GameEventKind::game_over:
            break;
    }
}

void Effects::step(const sim::Simulation& simulation)
{
    constexpr auto kStep = static_cast<float>(sim::kTickSeconds);
    hits_.clear();
    drops_.advance(kStep, hits_);
    for (const WallHit& hit : hits_) {
        // Only what is large enough to be seen, and never in the place of what fruit leave.
        if (hit.size < kSmallestStain || stains_.all().size() > Stains::kMost / 2) continue;
        const float shape = hit.place.x * 0.37f + hit.place.y * 0.53f;
        stains_.add({glm::vec2(hit.place), hit.colour, 3.0f * hit.size, shape - std::floor(shape)});
    }
    stains_.advance(kStep);
    popups_.advance(kStep);
    shake_.advance(kStep);
    flash_ = std::max(flash_ - kFlashFades * kStep, 0.0f);
    slowed_ = std::max(slowed_ - kStep, 0.0f);

    if (const game::GameScene* const played = game::game_of(simulation.scene()))
        for (const auto& body : simulation.bodies()) {
            if (played->whole(body->id()) != game::FruitKind::bomb) continue;
            // The fuse ends at the top of the model.
            const Box& box = simulation.models().model(body->identity().origin.model).box;
            const glm::dvec3 centre = sim::centre_of(box);
            const glm::dvec3 tip(centre.x, double(box.hi.y), centre.z);
            add_fuse_sparks(glm::vec3(body->pose().to_world(tip)), std::uint64_t(now_) * 64 + body->id(), drops_);
        }
}

}  // namespace kerf::effects
