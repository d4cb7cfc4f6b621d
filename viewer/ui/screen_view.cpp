#include "viewer/ui/screen_view.h"

#include <algorithm>
#include <array>

#include "viewer/game/game_mode.h"
#include "viewer/ui/hud.h"
#include "viewer/ui/texts.h"

namespace kerf::ui {

namespace {

/// How dark the wall is made behind words, 0 to 1.
constexpr float kVeil = 0.42f;

/// The measures of a screen, all in pixels of the picture, made of units.
class Layout
{
public:
    explicit Layout(Canvas& canvas) : canvas_(canvas), u_(canvas.unit()), size_(canvas.size()) {}

    Canvas& canvas() { return canvas_; }
    float u() const { return u_; }
    const glm::vec2& size() const { return size_; }

    /// A card in the middle of the picture, `width` and `height` in units.
    Box2 middle_card(float width, float height)
    {
        const glm::vec2 half = 0.5f * u_ * glm::vec2(width, height);
        const Box2 box{0.5f * size_ - half, 0.5f * size_ + half};
        canvas_.fill({{0.0f, 0.0f}, size_}, kInk, 0.45f);
        canvas_.card(box);
        return box;
    }

    /// A line of a menu, centred at `middle`; gives its place.
    Hotspot button(const glm::vec2& middle, float width, const std::string& label, bool is_selected)
    {
        const glm::vec2 half = 0.5f * u_ * glm::vec2(width, 46.0f);
        const Box2 box{middle - half, middle + half};
        canvas_.fill(box, is_selected ? kAccent : kPaper, is_selected ? 0.92f : 0.10f, 10.0f * u_);
        canvas_.text(middle, {0.5f, 0.54f}, label, 26.0f, is_selected ? kInk : kPaper);
        return {box, {}};
    }

private:
    Canvas& canvas_;
    float u_;
    glm::vec2 size_;
};

std::vector<Hotspot> show_menu(Layout& layout, const Screens& screens)
{
    Canvas& canvas = layout.canvas();
    const float u = layout.u();
    const glm::vec2 size = layout.size();
    canvas.text({0.5f * size.x, 30.0f * u}, {0.5f, 0.0f}, "KERF", 104.0f, kPaper);
    const glm::vec2 how{0.5f * size.x, 160.0f * u}, around = u * glm::vec2(350.0f, 24.0f);
    canvas.fill({how - around, how + around}, kInk, kVeil, 10.0f * u);
    canvas.text(how, {0.5f, 0.5f}, "Hold the left button and drag across a fruit to cut it", 28.0f, kAccent);
    std::vector<Hotspot> hotspots;
    const Box2 whole{{0.0f, 0.0f}, size};
    for (std::size_t i = 0; i < modes().size(); ++i) {
        const bool is_selected = screens.selected() == i;
        const glm::vec2 middle = on_picture(place_of_mode(i), whole);
        const glm::vec2 below = on_picture(place_of_mode(i) - glm::dvec2(0.0, kModeRadius + 0.30), whole);
        const float wide = 0.5f * (on_picture({2.6, 0.0}, whole).x - on_picture({0.0, 0.0}, whole).x);
        const glm::vec2 title(middle.x, below.y);
        // Only the words can be clicked: on the fruit a press begins a swipe.
        const Box2 box{{title.x - wide, title.y - 24.0f * u}, {title.x + wide, title.y + 58.0f * u}};
        canvas.fill(box, is_selected ? kAccent : kInk, is_selected ? 0.92f : kVeil, 10.0f * u);
        canvas.text(title, {0.5f, 0.5f}, modes()[i].title, 34.0f, is_selected ? kInk : kPaper);
        canvas.text(title + glm::vec2(0.0f, 36.0f * u), {0.5f, 0.5f}, modes()[i].promise, 18.0f,
                    is_selected ? kInk : kPaper);
        hotspots.push_back({box, {}});
    }
    for (std::size_t i = modes().size(); i < screens.items().size(); ++i) {
        const float place = static_cast<float>(i - modes().size()) - 1.0f;
        const glm::vec2 at{0.5f * size.x + place * 216.0f * u, size.y - 96.0f * u};
        const glm::vec2 half = u * glm::vec2(100.0f, 23.0f);
        canvas.fill({at - half, at + half}, kInk, kVeil, 10.0f * u);
        hotspots.push_back(layout.button(at, 200.0f, screens.items()[i].label, screens.selected() == i));
    }
    canvas.text({0.5f * size.x, size.y - 26.0f * u}, {0.5f, 1.0f}, "or choose with the arrow keys and Enter", 20.0f,
                kPaper);
    return hotspots;
}

std::vector<Hotspot> show_buttons(Layout& layout, const Screens& screens, const glm::vec2& first, float width)
{
    std::vector<Hotspot> hotspots;
    for (std::size_t i = 0; i < screens.items().size(); ++i)
        hotspots.push_back(layout.button(first + glm::vec2(0.0f, 58.0f * layout.u() * static_cast<float>(i)), width,
                                         screens.items()[i].label, screens.selected() == i));
    return hotspots;
}

/// Below what is written at the upper right edge: fruit seldom come there, and no swipe begins there.
std::vector<Hotspot> show_pause_button(Layout& layout, const glm::vec2& pointer)
{
    Canvas& canvas = layout.canvas();
    const float u = layout.u();
    const glm::vec2 half = u * glm::vec2(30.0f, 29.0f), middle(layout.size().x - 52.0f * u, 133.0f * u);
    const Box2 box{middle - half, middle + half};
    const bool is_pointed = box.holds(pointer);
    const glm::vec3 colour = is_pointed ? kInk : kPaper;
    canvas.fill(box, is_pointed ? kAccent : kInk, is_pointed ? 0.92f : kVeil, 12.0f * u);
    for (const float side : {-1.0f, 1.0f}) {
        const glm::vec2 bar = middle + u * glm::vec2(6.5f * side, -8.0f), extent = u * glm::vec2(3.5f, 11.0f);
        canvas.fill({bar - extent, bar + extent}, colour, 0.95f, 1.5f * u);
    }
    canvas.text(middle + glm::vec2(0.0f, 17.0f * u), {0.5f, 0.5f}, "Esc", 16.0f, colour);
    return {{box, {}}};
}

std::vector<Hotspot> show_paused(Layout& layout, const Screens& screens)
{
    const Box2 card = layout.middle_card(460.0f, 484.0f);
    const float u = layout.u(), middle = card.middle().x;
    layout.canvas().text(
        {middle, card.high.y - 22.0f * u}, {0.5f, 1.0f},
        "W A S D: steer      Space held: cut\nEsc or P: go on      M: sound\nF11: full screen      F12: save a picture",
        20.0f, kPaper);
    layout.canvas().text({middle, card.low.y + 28.0f * u}, {0.5f, 0.0f}, "Paused", 60.0f, kPaper);
    return show_buttons(layout, screens, {middle, card.low.y + 142.0f * u}, 320.0f);
}

std::string_view why(const game::GameState& state)
{
    switch (state.end) {
        case game::GameEnd::bomb:
            return "That was a bomb";
        case game::GameEnd::missed:
            return "Too many missed";
        case game::GameEnd::time:
            return "Time is up";
        default:
            return "The game is over";
    }
}

void row(Layout& layout, const Box2& card, float y, const std::string& label, const std::string& value)
{
    const float u = layout.u();
    layout.canvas().text({card.low.x + 56.0f * u, y}, {0.0f, 0.5f}, label, 22.0f, kDim);
    layout.canvas().text({card.high.x - 56.0f * u, y}, {1.0f, 0.5f}, value, 22.0f, kPaper);
}

std::vector<Hotspot> show_over(Layout& layout, const Screens& screens, const ScreenContent& content)
{
    const Box2 card = layout.middle_card(520.0f, 590.0f);
    const float u = layout.u(), middle = card.middle().x;
    Canvas& canvas = layout.canvas();
    if (content.game == nullptr) {
        canvas.text({middle, card.low.y + 60.0f * u}, {0.5f, 0.0f}, "The end", 60.0f, kPaper);
        return show_buttons(layout, screens, {middle, card.high.y - 172.0f * u}, 320.0f);
    }
    const game::GameState& state = *content.game;
    canvas.text({middle, card.low.y + 26.0f * u}, {0.5f, 0.0f}, why(state), 40.0f, kPaper);
    canvas.text({middle, card.low.y + 78.0f * u}, {0.5f, 0.0f}, std::to_string(state.score), 112.0f, kAccent);
    if (state.counts.fruit_cut == 0)
        canvas.text({middle, card.low.y + 194.0f * u}, {0.5f, 0.0f}, "Hold the left button and drag across the fruit",
                    22.0f, kPaper);
    else if (state.best > 0)
        canvas.text({middle, card.low.y + 192.0f * u}, {0.5f, 0.0f},
                    state.is_best ? std::string("New best!") : std::string("Best ").append(std::to_string(state.best)),
                    26.0f, state.is_best ? kAccent : kDim);
    const float top = card.low.y + 252.0f * u;
    const std::array<std::pair<const char*, std::int64_t>, 5> rows{{{"Fruit cut", state.counts.fruit_cut},
                                                                    {"Missed", state.counts.fruit_missed},
                                                                    {"Combos", state.counts.combos},
                                                                    {"Longest combo", state.counts.longest_combo},
                                                                    {"Critical cuts", state.counts.criticals}}};
    for (std::size_t i = 0; i < rows.size(); ++i)
        row(layout, card, top + 30.0f * u * static_cast<float>(i), rows[i].first, std::to_string(rows[i].second));
    return show_buttons(layout, screens, {middle, card.high.y - 156.0f * u}, 320.0f);
}

/// "halfedge wins": who spent less on the same swipes.
std::string verdict(const std::vector<DuelSide>& sides)
{
    if (sides[0].cuts == 0 && sides[1].cuts == 0) return "Nothing was cut";
    return (sides[0].cut_ms <= sides[1].cut_ms ? sides[0] : sides[1]).backend + " wins";
}

std::vector<Hotspot> show_duel_over(Layout& layout, const Screens& screens, const std::vector<DuelSide>& sides)
{
    const Box2 card = layout.middle_card(760.0f, 590.0f);
    const float u = layout.u();
    Canvas& canvas = layout.canvas();
    canvas.text({card.middle().x, card.low.y + 26.0f * u}, {0.5f, 0.0f}, verdict(sides), 48.0f, kPaper);
    const bool first_leads = sides[0].cut_ms <= sides[1].cut_ms;
    for (std::size_t i = 0; i < 2; ++i) {
        const DuelSide& side = sides[i];
        const float right = card.high.x - (i == 0 ? 256.0f : 56.0f) * u;
        float y = card.low.y + 128.0f * u;
        const auto value = [&](const std::string& text, float height, const glm::vec3& colour) {
            canvas.text({right, y}, {1.0f, 0.5f}, text, height, colour);
            y += 50.0f * u;
        };
        value(side.backend, 24.0f, kDim);
        value(milliseconds_text(side.cut_ms), 38.0f, (i == 0) == first_leads ? kLead : kDanger);
        value(std::to_string(side.cuts), 24.0f, kPaper);
        value(milliseconds_text(side.worst_cut_ms), 24.0f, kPaper);
        value(milliseconds_text(side.worst_frame_ms), 24.0f, kPaper);
        value(std::to_string(side.lost_frames), 24.0f, kPaper);
    }
    float y = card.low.y + 178.0f * u;
    for (const char* label : {"Spent on cutting", "Cuts", "Longest cut", "Worst frame", "Frames lost"}) {
        canvas.text({card.low.x + 56.0f * u, y}, {0.0f, 0.5f}, label, 24.0f, kDim);
        y += 50.0f * u;
    }
    canvas.text({card.middle().x, card.high.y - 22.0f * u}, {0.5f, 1.0f}, "R or Enter: rematch", 18.0f, kDim);
    return show_buttons(layout, screens, {card.middle().x, card.high.y - 142.0f * u}, 320.0f);
}

std::vector<Hotspot> show_settings(Layout& layout, const Screens& screens)
{
    const Box2 card = layout.middle_card(720.0f, 540.0f);
    const float u = layout.u();
    Canvas& canvas = layout.canvas();
    canvas.text({card.middle().x, card.low.y + 24.0f * u}, {0.5f, 0.0f}, "Settings", 56.0f, kPaper);
    std::vector<Hotspot> hotspots;
    for (std::size_t i = 0; i < screens.items().size(); ++i) {
        const ui::MenuItem& item = screens.items()[i];
        const bool is_selected = screens.selected() == i;
        const float y = card.low.y + (130.0f + 56.0f * static_cast<float>(i)) * u;
        if (item.value.empty()) {
            hotspots.push_back(layout.button({card.middle().x, y + 8.0f * u}, 240.0f, item.label, is_selected));
            continue;
        }
        const Box2 box{{card.low.x + 28.0f * u, y - 24.0f * u}, {card.high.x - 28.0f * u, y + 24.0f * u}};
        canvas.fill(box, is_selected ? kAccent : kPaper, is_selected ? 0.30f : 0.05f, 10.0f * u);
        canvas.text({box.low.x + 22.0f * u, y}, {0.0f, 0.54f}, item.label, 24.0f, kPaper);
        Hotspot hotspot{box, {}};
        float right = box.high.x - 22.0f * u;
        canvas.text({right, y}, {1.0f, 0.54f}, item.value, 24.0f, kAccent);
        if (item.share) {
            right -= 150.0f * u;
            hotspot.slider = {{right - 200.0f * u, y - 7.0f * u}, {right, y + 7.0f * u}};
            canvas.bar(hotspot.slider, static_cast<float>(*item.share), kAccent);
        }
        hotspots.push_back(hotspot);
    }
    canvas.text({card.middle().x, card.high.y + 20.0f * u}, {0.5f, 0.0f}, "Arrow keys change, Esc leads back", 18.0f,
                kDim);
    return hotspots;
}

std::vector<Hotspot> show_scores(Layout& layout, const Screens& screens, const ScreenContent& content)
{
    const Box2 card = layout.middle_card(1020.0f, 580.0f);
    const float u = layout.u();
    Canvas& canvas = layout.canvas();
    canvas.text({card.middle().x, card.low.y + 24.0f * u}, {0.5f, 0.0f}, "High scores", 56.0f, kPaper);
    for (std::size_t m = 0; m < content.scores.size(); ++m) {
        const float width = card.size().x / static_cast<float>(content.scores.size());
        const float middle = card.low.x + (static_cast<float>(m) + 0.5f) * width;
        const auto& [title, lines] = content.scores[m];
        canvas.text({middle, card.low.y + 112.0f * u}, {0.5f, 0.0f}, title, 32.0f, kAccent);
        if (lines.empty()) canvas.text({middle, card.low.y + 172.0f * u}, {0.5f, 0.0f}, "no game yet", 20.0f, kDim);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const float y = card.low.y + (172.0f + 34.0f * static_cast<float>(i)) * u;
            const glm::vec3 colour = lines[i].is_latest ? kAccent : kPaper;
            // A number of any length stays in its column.
            const std::string score = std::to_string(lines[i].score);
            const float room = 0.5f * width - 46.0f * u, wide = canvas.measure(score, 26.0f).x;
            const float height = 26.0f * std::min(1.0f, room / wide);
            canvas.text({middle - 30.0f * u, y}, {1.0f, 0.5f}, score, height, colour);
            canvas.text({middle - 8.0f * u, y}, {0.0f, 0.5f}, lines[i].date, 18.0f, kDim);
        }
    }
    return show_buttons(layout, screens, {card.middle().x, card.high.y - 46.0f * u}, 240.0f);
}

}  // namespace

glm::dvec2 place_of_mode(std::size_t mode)
{
    constexpr double kApart = 2.72, kHeight = 0.30;
    const double from_middle = double(mode) - 0.5 * double(modes().size() - 1);
    return {kApart * from_middle, kHeight};
}

namespace {

std::vector<Hotspot> show_lines(Layout& layout, const Screens& screens, const ScreenContent& content)
{
    switch (screens.screen()) {
        case Screen::menu:
            return show_menu(layout, screens);
        case Screen::play:
            return show_pause_button(layout, content.pointer);
        case Screen::paused:
            return show_paused(layout, screens);
        case Screen::over:
            if (content.duel.size() == 2) return show_duel_over(layout, screens, content.duel);
            return show_over(layout, screens, content);
        case Screen::scores:
            return show_scores(layout, screens, content);
        case Screen::settings:
            return show_settings(layout, screens);
    }
    return {};
}

/// Over everything else, for the seconds that it is there.
void show_message(Layout& layout, const std::string& message)
{
    if (message.empty()) return;
    constexpr float kHeight = 24.0f;
    Canvas& canvas = layout.canvas();
    const float u = layout.u(), around = 14.0f * u;
    const std::string lines = canvas.wrapped(message, kHeight, 0.86f * layout.size().x);
    const glm::vec2 extent = canvas.measure(lines, kHeight);
    const glm::vec2 low(0.5f * (layout.size().x - extent.x), layout.size().y - extent.y - around - 8.0f * u);
    canvas.card({low - around, low + extent + around}, 1.0f);
    canvas.text(low, {0.0f, 0.0f}, lines, kHeight, kPaper);
}

}  // namespace

std::vector<Hotspot> show_screen(Canvas& canvas, const Screens& screens, const ScreenContent& content)
{
    Layout layout(canvas);
    std::vector<Hotspot> hotspots = show_lines(layout, screens, content);
    show_message(layout, content.message);
    return hotspots;
}

std::optional<Pointed> item_at(const std::vector<Hotspot>& hotspots, const glm::vec2& place)
{
    for (std::size_t i = 0; i < hotspots.size(); ++i) {
        if (!hotspots[i].box.holds(place)) continue;
        Pointed pointed{i, 1.0};
        if (const Box2& slider = hotspots[i].slider; slider.size().x > 0.0f)
            pointed.share = std::clamp(double((place.x - slider.low.x) / slider.size().x), 0.0, 1.0);
        return pointed;
    }
    return std::nullopt;
}

}  // namespace kerf::ui
