#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "viewer/app/game/game_show.h"
#include "viewer/game/giant_scene.h"
#include "viewer/game/giant_sizes.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/back_ends.h"
#include "viewer/ui/texts.h"

// The part of the show that belongs to the scene `giant`: how large it is, what a cut takes, whether it was felt.

namespace kerf::app {

namespace {

/// The slider is even in the logarithm.
std::int64_t giant_triangles(double share)
{
    const double low = std::log(double(game::kFewestGiantTriangles)),
                 high = std::log(double(game::kMostGiantTriangles));
    const double exact = std::exp(low + share * (high - low));
    const double grid = std::pow(10.0, std::floor(std::log10(exact)) - 1.0);
    return std::clamp(static_cast<std::int64_t>(std::llround(exact / grid) * std::llround(grid)),
                      game::kFewestGiantTriangles, game::kMostGiantTriangles);
}

double giant_share(std::int64_t triangles)
{
    const double low = std::log(double(game::kFewestGiantTriangles)),
                 high = std::log(double(game::kMostGiantTriangles));
    return std::clamp((std::log(double(std::max<std::int64_t>(triangles, 1))) - low) / (high - low), 0.0, 1.0);
}

/// Of the time that a giant takes in all, what is over when its mesh is ready; the rest is its way onto the graphics
/// card.
constexpr double kMakingShare = 0.95;

std::string with_unit(const char* label, double ms)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%s  %.1f ms", label, ms);
    return text.data();
}

}  // namespace

void GameShow::set_giant(double share)
{
    giant_share_ = std::clamp(share, 0.0, 1.0);
    const std::int64_t triangles = giant_triangles(giant_share_);
    simulation_->command("size " + std::to_string(triangles));
    game::StoredSettings changed = settings();
    changed.giant = triangles;
    screens_.set_settings(changed);
    store_settings();
}

void GameShow::next_backend()
{
    if (scene_ != "giant" || !simulation_) return;
    const std::vector<std::string>& names = sim::backend_names();
    const std::string baseline = sim::find_backend("baseline");
    simulation_->command("backend " + (simulation_->backend() == baseline ? names.front() : baseline));
    next_giant();
}

void GameShow::next_giant()
{
    if (scene_ == "giant" && simulation_) simulation_->command("next");
}

void GameShow::write_giant(ui::Canvas& canvas)
{
    const game::GiantScene* const scene = game::giant_of(simulation_->scene());
    if (scene == nullptr) return;
    const game::GiantState state = scene->state();
    if (!giant_sliding_) giant_share_ = giant_share(state.triangles);
    const float u = canvas.unit();
    const bool in_software = render::draws_in_software();
    // A line for each back end that has cut, and one that says what to do before the present one has.
    const std::size_t lines = cut_times_.series().size() + (cut_times_.of(simulation_->backend()) == nullptr ? 1u : 0u);
    const float more = 24.0f * static_cast<float>(lines + (in_software ? 1u : 0u));
    const ui::Box2 card{{24.0f * u, 24.0f * u}, {404.0f * u, (382.0f + more) * u}};
    canvas.card(card, 0.70f);
    const float left = card.low.x + 22.0f * u, right = card.high.x - 22.0f * u;
    float y = card.low.y + 16.0f * u;
    const auto line = [&](const std::string& text, float height, const glm::vec3& colour) {
        canvas.text({left, y}, {0.0f, 0.0f}, text, height, colour);
        y += 1.32f * height * u;
    };
    line(ui::number_text(giant_triangles(giant_share_)), 36.0f, ui::kPaper);
    line("triangles, cut by " + simulation_->backend(), 18.0f, ui::kDim);
    giant_slider_ = {{left, y + 4.0f * u}, {right, y + 20.0f * u}};
    canvas.bar(giant_slider_, static_cast<float>(giant_share_), ui::kAccent);
    y += 34.0f * u;

    const auto draw = [&](const ui::Box2& box, const FrameStatistics& times, double most, const glm::vec3& colour) {
        const bool wraps = times.size() == FrameStatistics::kShown;
        canvas.plot(box, times.values(), static_cast<int>(times.size()), wraps ? static_cast<int>(times.offset()) : 0,
                    static_cast<float>(std::max(33.0, most)), colour);
    };
    line(with_unit("frame", frames_.last()) + with_unit("   longest", frames_.worst_since_reset()), 18.0f, ui::kPaper);
    if (in_software) line("frames by a software renderer", 18.0f, ui::kDim);
    const ui::Box2 frames{{left, y}, {right, y + 58.0f * u}};
    canvas.fill(frames, ui::kPaper, 0.06f, 4.0f * u);
    draw(frames, frames_, 1.1 * frames_.most(), ui::kIce);
    y += 68.0f * u;

    const std::string baseline = sim::find_backend("baseline");
    const auto colour_of = [&](const std::string& backend) { return backend == baseline ? ui::kDanger : ui::kLead; };
    if (cut_times_.of(simulation_->backend()) == nullptr)
        line("cut by " + simulation_->backend() + ": swipe across it", 18.0f, ui::kPaper);
    for (const CutTimes::Series& series : cut_times_.series())
        line(with_unit(series.backend.c_str(), series.times.last()) + with_unit("   longest", series.times.most()),
             18.0f, colour_of(series.backend));
    const ui::Box2 cuts{{left, y}, {right, y + 58.0f * u}};
    canvas.fill(cuts, ui::kPaper, 0.06f, 4.0f * u);
    // One scale for all, so that one sees who takes longer.
    for (const CutTimes::Series& series : cut_times_.series())
        draw(cuts, series.times, 1.1 * cut_times_.most(), colour_of(series.backend));
    y += 68.0f * u;
    const float gap = 10.0f * u, width = 0.5f * (right - left - gap);
    constexpr std::array<const char*, 2> kLabels{"B: other back end", "N: next one"};
    for (std::size_t i = 0; i < kLabels.size(); ++i) {
        const float start = left + static_cast<float>(i) * (width + gap);
        ui::Box2& box = giant_buttons_[i];
        box = {{start, y}, {start + width, y + 34.0f * u}};
        const bool is_pointed = box.holds(pointed_at_);
        canvas.fill(box, is_pointed ? ui::kAccent : ui::kPaper, is_pointed ? 0.92f : 0.12f, 8.0f * u);
        canvas.text(box.middle(), {0.5f, 0.54f}, kLabels[i], 18.0f, is_pointed ? ui::kInk : ui::kPaper);
    }
    y += 42.0f * u;
    line("Left, Right: size   Esc: pause", 16.0f, ui::kDim);

    const std::optional<double> progress = giant_progress();
    if (!progress) return;
    const bool is_made = state.stage == game::GiantStage::ready;
    const glm::vec2 middle = 0.5f * canvas.size();
    canvas.text(middle, {0.5f, 0.5f}, is_made ? "uploading" : std::string(name_of(state.stage)), 30.0f, ui::kPaper);
    canvas.bar({{middle.x - 160.0f * u, middle.y + 34.0f * u}, {middle.x + 160.0f * u, middle.y + 46.0f * u}},
               static_cast<float>(*progress), ui::kAccent);
}

std::optional<double> GameShow::giant_progress() const
{
    const game::GiantScene* const scene = simulation_ ? game::giant_of(simulation_->scene()) : nullptr;
    if (scene == nullptr) return std::nullopt;
    const game::GiantState state = scene->state();
    const std::optional<double> arriving = painter_.world().arriving();
    if (state.is_held && arriving.value_or(1.0) >= 1.0) return std::nullopt;
    if (!state.is_held && !state.is_expected && state.stage == game::GiantStage::ready) return std::nullopt;
    if (state.stage != game::GiantStage::ready) return kMakingShare * state.progress;
    return kMakingShare + (1.0 - kMakingShare) * arriving.value_or(0.0);
}

}  // namespace kerf::app
