#include "viewer/app/game/giant_controls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "viewer/game/giant_sizes.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/back_ends.h"
#include "viewer/ui/texts.h"

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

/// Lines of text and plots, one below another.
class Column
{
public:
    Column(ui::Canvas& canvas, const ui::Box2& card)
        : canvas_(canvas),
          unit_(canvas.unit()),
          left_(card.low.x + 22.0f * unit_),
          right_(card.high.x - 22.0f * unit_),
          y_(card.low.y + 16.0f * unit_)
    {
    }

    void line(const std::string& text, float height, const glm::vec3& colour)
    {
        canvas_.text({left_, y_}, {0.0f, 0.0f}, text, height, colour);
        y_ += 1.32f * height * unit_;
    }
    /// A box as wide as the column. In units: how far below the last line it begins, its height, and what it takes.
    ui::Box2 box(float gap, float height, float step)
    {
        const ui::Box2 box{{left_, y_ + gap * unit_}, {right_, y_ + (gap + height) * unit_}};
        y_ += step * unit_;
        return box;
    }

private:
    ui::Canvas& canvas_;
    float unit_, left_, right_, y_;
};

void plot(ui::Canvas& canvas, const ui::Box2& box, const FrameStatistics& times, double most, const glm::vec3& colour)
{
    const bool wraps = times.size() == FrameStatistics::kShown;
    canvas.plot(box, times.values(), static_cast<int>(times.size()), wraps ? static_cast<int>(times.offset()) : 0,
                static_cast<float>(std::max(33.0, most)), colour);
}

}  // namespace

GiantControls::GiantControls(sim::Simulation& simulation, const FrameStatistics& frames)
    : simulation_(simulation), frames_(frames)
{
}

std::int64_t GiantControls::choose(double share)
{
    share_ = std::clamp(share, 0.0, 1.0);
    const std::int64_t triangles = giant_triangles(share_);
    simulation_.command("size " + std::to_string(triangles));
    return triangles;
}

void GiantControls::next_backend()
{
    const std::string baseline = sim::known_back_end("baseline");
    const bool is_baseline = simulation_.backend() == baseline;
    simulation_.command("backend " + (is_baseline ? sim::backend_names().front() : baseline));
    next_giant();
}

bool GiantControls::press_button(const glm::vec2& place)
{
    for (std::size_t i = 0; i < buttons_.size(); ++i) {
        if (!buttons_[i].holds(place)) continue;
        i == 0 ? next_backend() : next_giant();
        return true;
    }
    return false;
}

bool GiantControls::drag(const WindowPointer& change, bool may_begin)
{
    using Kind = WindowPointer::Kind;
    const glm::vec2 place(change.position);
    if (may_begin && change.kind == Kind::press && slider_.holds(place)) is_sliding_ = true;
    if (!is_sliding_) return false;
    share_ = std::clamp(double((place.x - slider_.low.x) / std::max(slider_.size().x, 1.0f)), 0.0, 1.0);
    if (change.kind == Kind::release) is_sliding_ = false;
    return true;
}

std::optional<double> GiantControls::progress(std::optional<double> arriving) const
{
    const game::GiantState state = giant().state();
    if (state.is_held && arriving.value_or(1.0) >= 1.0) return std::nullopt;
    if (!state.is_held && !state.is_expected && state.stage == game::GiantStage::ready) return std::nullopt;
    if (state.stage != game::GiantStage::ready) return kMakingShare * state.progress;
    return kMakingShare + (1.0 - kMakingShare) * arriving.value_or(0.0);
}

void GiantControls::write(ui::Canvas& canvas, const glm::vec2& pointer, std::optional<double> arriving)
{
    if (!is_sliding_) share_ = giant_share(giant().state().triangles);
    write_panel(canvas, pointer);
    if (const std::optional<double> share = progress(arriving)) write_progress(canvas, *share);
}

void GiantControls::write_panel(ui::Canvas& canvas, const glm::vec2& pointer)
{
    const float u = canvas.unit();
    const std::string backend = simulation_.backend(), baseline = sim::known_back_end("baseline");
    const bool has_cut = cut_times_.of(backend) != nullptr, in_software = render::draws_in_software();
    // A line for each back end that has cut, and one that says what to do before the present one has.
    const std::size_t lines = cut_times_.series().size() + (has_cut ? 0u : 1u);
    const float more = 24.0f * static_cast<float>(lines + (in_software ? 1u : 0u));
    const ui::Box2 card{{24.0f * u, 24.0f * u}, {404.0f * u, (382.0f + more) * u}};
    canvas.card(card, 0.70f);
    Column column(canvas, card);
    column.line(ui::number_text(giant_triangles(share_)), 36.0f, ui::kPaper);
    column.line("triangles, cut by " + backend, 18.0f, ui::kDim);
    slider_ = column.box(4.0f, 16.0f, 34.0f);
    canvas.bar(slider_, static_cast<float>(share_), ui::kAccent);

    column.line(with_unit("frame", frames_.last()) + with_unit("   longest", frames_.worst_since_reset()), 18.0f,
                ui::kPaper);
    if (in_software) column.line("frames by a software renderer", 18.0f, ui::kDim);
    const ui::Box2 frames = column.box(0.0f, 58.0f, 68.0f);
    canvas.fill(frames, ui::kPaper, 0.06f, 4.0f * u);
    plot(canvas, frames, frames_, 1.1 * frames_.most(), ui::kIce);

    const auto colour_of = [&](const std::string& name) { return name == baseline ? ui::kDanger : ui::kLead; };
    if (!has_cut) column.line("cut by " + backend + ": swipe across it", 18.0f, ui::kPaper);
    for (const CutTimes::Series& series : cut_times_.series())
        column.line(
            with_unit(series.backend.c_str(), series.times.last()) + with_unit("   longest", series.times.most()),
            18.0f, colour_of(series.backend));
    const ui::Box2 cuts = column.box(0.0f, 58.0f, 68.0f);
    canvas.fill(cuts, ui::kPaper, 0.06f, 4.0f * u);
    // One scale for all, so that one sees who takes longer.
    for (const CutTimes::Series& series : cut_times_.series())
        plot(canvas, cuts, series.times, 1.1 * cut_times_.most(), colour_of(series.backend));

    write_buttons(canvas, column.box(0.0f, 34.0f, 42.0f), pointer);
    column.line("Left, Right: size   Esc: pause", 16.0f, ui::kDim);
}

void GiantControls::write_buttons(ui::Canvas& canvas, const ui::Box2& row, const glm::vec2& pointer)
{
    const float u = canvas.unit();
    const float gap = 10.0f * u, width = 0.5f * (row.size().x - gap);
    constexpr std::array<const char*, 2> kLabels{"B: other back end", "N: next one"};
    for (std::size_t i = 0; i < kLabels.size(); ++i) {
        const float start = row.low.x + static_cast<float>(i) * (width + gap);
        ui::Box2& box = buttons_[i];
        box = {{start, row.low.y}, {start + width, row.high.y}};
        const bool is_pointed = box.holds(pointer);
        canvas.fill(box, is_pointed ? ui::kAccent : ui::kPaper, is_pointed ? 0.92f : 0.12f, 8.0f * u);
        canvas.text(box.middle(), {0.5f, 0.54f}, kLabels[i], 18.0f, is_pointed ? ui::kInk : ui::kPaper);
    }
}

void GiantControls::write_progress(ui::Canvas& canvas, double progress) const
{
    const game::GiantStage stage = giant().state().stage;
    const float u = canvas.unit();
    const glm::vec2 middle = 0.5f * canvas.size();
    const bool is_made = stage == game::GiantStage::ready;
    canvas.text(middle, {0.5f, 0.5f}, is_made ? "uploading" : std::string(name_of(stage)), 30.0f, ui::kPaper);
    canvas.bar({{middle.x - 160.0f * u, middle.y + 34.0f * u}, {middle.x + 160.0f * u, middle.y + 46.0f * u}},
               static_cast<float>(progress), ui::kAccent);
}

}  // namespace kerf::app
