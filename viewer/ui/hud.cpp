#include "viewer/ui/hud.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "viewer/ui/texts.h"

namespace kerf::ui {

namespace {

constexpr double kLastSeconds = 10.0;

std::string_view title_of(game::FruitKind kind)
{
    switch (kind) {
        case game::FruitKind::freeze:
            return "Freeze";
        case game::FruitKind::frenzy:
            return "Frenzy";
        case game::FruitKind::hammer:
            return "Hammer";
        default:
            return "Double points";
    }
}

glm::vec3 colour_of(game::FruitKind kind)
{
    switch (kind) {
        case game::FruitKind::freeze:
            return kIce;
        case game::FruitKind::frenzy:
            return kAccent;
        case game::FruitKind::hammer:
            return {0.55f, 0.95f, 0.45f};
        default:
            return {0.86f, 0.62f, 1.0f};
    }
}

void show_lives(Canvas& canvas, const game::GameState& state)
{
    const float u = canvas.unit();
    const int places = std::max(state.lives, state.lives_at_start);
    for (int i = 0; i < places; ++i) {
        const glm::vec2 middle(canvas.size().x - (52.0f + 50.0f * static_cast<float>(i)) * u, 56.0f * u);
        if (i < state.lives)
            canvas.heart(middle, 20.0f * u, {0.93f, 0.16f, 0.20f}, 1.0f);
        else
            canvas.heart(middle, 20.0f * u, {0.30f, 0.31f, 0.31f}, 0.75f);
    }
}

void show_clock(Canvas& canvas, double seconds)
{
    const float u = canvas.unit();
    const bool hurry = seconds <= kLastSeconds;
    const double beat = seconds - std::floor(seconds);
    const float height = hurry ? 60.0f + 12.0f * static_cast<float>(beat * beat) : 60.0f;
    canvas.text({canvas.size().x - 36.0f * u, 22.0f * u}, {1.0f, 0.0f}, clock_text(seconds), height,
                hurry ? kDanger : kPaper);
}

void show_specials(Canvas& canvas, const game::GameState& state)
{
    const float u = canvas.unit();
    float y = 30.0f * u;
    for (const game::ActiveSpecial& special : state.specials) {
        const float middle = 0.5f * canvas.size().x;
        canvas.text({middle, y}, {0.5f, 0.0f}, title_of(special.kind), 28.0f, kPaper);
        y += 32.0f * u;
        canvas.bar({{middle - 110.0f * u, y}, {middle + 110.0f * u, y + 9.0f * u}},
                   static_cast<float>(special.share_left), colour_of(special.kind));
        y += 18.0f * u;
        if (special.kind == game::FruitKind::freeze)
            canvas.rim({{0.0f, 0.0f}, canvas.size()}, kIce,
                       0.45f * static_cast<float>(std::min(1.0, 4.0 * special.share_left)));
    }
}

}  // namespace

glm::vec2 on_picture(const glm::dvec2& stage, const Box2& box)
{
    const glm::dvec2 size(box.size());
    if (size.x < 1.0 || size.y < 1.0) return box.low;
    return box.low + glm::vec2(sim::Camera(size.x / size.y).stage_to_screen(stage, size));
}

void show_hud(Canvas& canvas, const game::GameState& state, std::string_view hint)
{
    const float u = canvas.unit();
    const std::string score = std::to_string(state.score);
    canvas.text({36.0f * u, 16.0f * u}, {0.0f, 0.0f}, score, 72.0f, kPaper);
    if (state.multiplier > 1)
        canvas.text({52.0f * u + canvas.measure(score, 72.0f).x, 40.0f * u}, {0.0f, 0.0f},
                    std::string("x").append(std::to_string(state.multiplier)), 40.0f,
                    colour_of(game::FruitKind::double_points));
    if (state.best > 0)
        canvas.text({38.0f * u, 92.0f * u}, {0.0f, 0.0f},
                    state.is_best ? std::string("New best!") : std::string("Best ").append(std::to_string(state.best)),
                    22.0f, state.is_best ? kAccent : kDim);
    if (state.lives_at_start > 0) show_lives(canvas, state);
    if (state.seconds_left) show_clock(canvas, *state.seconds_left);
    show_specials(canvas, state);
    canvas.text({0.5f * canvas.size().x, canvas.size().y - 36.0f * u}, {0.5f, 1.0f}, hint, 28.0f, kPaper);
}

void show_effects(Canvas& canvas, const effects::Effects& effects, const Box2& box)
{
    const float zoom = box.size().x / canvas.size().x;
    for (const effects::Popup& popup : effects.popups().all()) {
        const glm::dvec2 place(popup.place + glm::vec2(0.0f, popup.rise()));
        canvas.text(on_picture(place, box), {0.5f, 0.5f}, popup.text,
                    std::max(2.0f, zoom * 34.0f * popup.size * popup.scale()), popup.colour, popup.opacity());
    }
    if (effects.flash() > 0.0f) canvas.fill(box, {1.0f, 0.97f, 0.9f}, effects.flash());
}

}  // namespace kerf::ui
