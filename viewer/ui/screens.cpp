#include "viewer/ui/screens.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace kerf::ui {

namespace {

// Lines of the settings, in their order.
enum Setting : std::size_t
{
    kVolume,
    kMute,
    kBackend,
    kFullscreen,
    kWindowSize,
    kVsync,
    kSettingsBack,
};

constexpr double kVolumeStep = 0.05, kWindowStep = 0.25;

std::string yes_or_no(bool value)
{
    return value ? "on" : "off";
}

std::string window_text(double scale)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.0f x %.0f", std::round(1280.0 * scale), std::round(720.0 * scale));
    return text.data();
}

double window_share(double scale)
{
    return (scale - kSmallestWindow) / (kLargestWindow - kSmallestWindow);
}

game::StoredSettings within_bounds(game::StoredSettings p, const std::vector<std::string>& backends)
{
    p.volume = p.volume > 0.0 ? std::round(100.0 * std::min(p.volume, 1.0)) / 100.0 : 0.0;  // as it is shown
    p.window_scale = std::isfinite(p.window_scale) ? std::clamp(p.window_scale, kSmallestWindow, kLargestWindow) : 1.0;
    if (std::find(backends.begin(), backends.end(), p.backend) == backends.end())
        p.backend = backends.empty() ? std::string() : backends.front();
    return p;
}

}  // namespace

const std::vector<std::string>& screen_names()
{
    static const std::vector<std::string> names{"menu", "play", "paused", "over", "scores", "settings"};
    return names;
}

std::optional<Screen> find_screen(std::string_view name)
{
    for (std::size_t i = 0; i < screen_names().size(); ++i)
        if (screen_names()[i] == name) return static_cast<Screen>(i);
    return std::nullopt;
}

const std::vector<Mode>& modes()
{
    static const std::vector<Mode> all{
        {"classic", "Classic", "3 misses or a bomb end it", "watermelon"},
        {"arcade", "Arcade", "60 s, bombs cost points", "banana"},
        {"zen", "Zen", "90 s of peace", "apple"},
        {"giant", "Giant", "up to 4 million triangles", "asteroid"},
        {"duel", "Duel", "two back ends, one swipe", "coconut"},
    };
    return all;
}

const Mode* find_mode(std::string_view scene)
{
    for (const Mode& mode : modes())
        if (mode.scene == scene) return &mode;
    return nullptr;
}

Screens::Screens(game::StoredSettings settings, std::vector<std::string> backends)
    : settings_(within_bounds(std::move(settings), backends)), backends_(std::move(backends))
{
    list_items();
}

void Screens::set_settings(const game::StoredSettings& settings)
{
    settings_ = within_bounds(settings, backends_);
    list_items();
}

/// Among modes(); the first before anything was played.
std::size_t Screens::last_played() const
{
    const Mode* const mode = find_mode(settings_.scene);
    return mode == nullptr ? 0 : static_cast<std::size_t>(mode - modes().data());
}

void Screens::show(Screen screen)
{
    if (screen == Screen::settings || screen == Screen::scores) {
        if (screen_ != Screen::settings && screen_ != Screen::scores) {
            before_ = screen_;
            selected_before_ = selected_;
        }
    }
    screen_ = screen;
    ++shown_;
    selected_ = screen == Screen::menu ? last_played() : 0;
    column_ = last_played();
    list_items();
}

void Screens::play(std::string scene)
{
    scene_ = std::move(scene);
    if (find_mode(scene_) != nullptr) settings_.scene = scene_;
    show(Screen::play);
}

bool Screens::holds_game() const
{
    if (screen_ == Screen::settings || screen_ == Screen::scores) return before_ == Screen::paused;
    return screen_ == Screen::paused;
}

void Screens::list_items()
{
    items_.clear();
    switch (screen_) {
        case Screen::menu:
            for (const Mode& mode : modes()) items_.push_back({std::string(mode.title)});
            for (const char* label : {"High scores", "Settings", "Quit"}) items_.push_back({label});
            break;
        case Screen::play:
            items_.push_back({"Pause"});
            break;
        case Screen::paused:
            for (const char* label : {"Go on", "Start again", "Settings", "Menu"}) items_.push_back({label});
            break;
        case Screen::over:
            if (scene_ == "duel")
                for (const char* label : {"Rematch", "Menu"}) items_.push_back({label});
            else
                for (const char* label : {"Play again", "High scores", "Menu"}) items_.push_back({label});
            break;
        case Screen::scores:
            items_.push_back({"Back"});
            break;
        case Screen::settings: {
            const int percent = static_cast<int>(std::lround(100.0 * settings_.volume));
            items_.push_back({"Volume", std::to_string(percent).append(" %"), settings_.volume});
            items_.push_back({"Sound", yes_or_no(!settings_.mute)});
            items_.push_back({"Back end", settings_.backend});
            items_.push_back({"Full screen", yes_or_no(settings_.fullscreen)});
            items_.push_back({"Window", window_text(settings_.window_scale), window_share(settings_.window_scale)});
            items_.push_back({"Wait for the screen (vsync)", yes_or_no(settings_.vsync)});
            items_.push_back({"Back"});
            break;
        }
    }
    selected_ = std::min(selected_, items_.empty() ? 0 : items_.size() - 1);
}

void Screens::step_in_menu(MenuKey key)
{
    const std::size_t games = modes().size(), others = items_.size() - games;
    const bool is_game = selected_ < games;
    if (key == MenuKey::up || key == MenuKey::down) {
        // Below any game is the first of the other lines: from none of them do two keys end the program.
        if (is_game) column_ = selected_;
        selected_ = is_game ? games : column_;
        return;
    }
    const std::size_t first = is_game ? 0 : games, count = is_game ? games : others;
    selected_ = first + (selected_ - first + (key == MenuKey::left ? count - 1 : 1)) % count;
}

std::optional<Request> Screens::press(MenuKey key)
{
    const bool is_arrow = key != MenuKey::accept && key != MenuKey::back;
    if (screen_ == Screen::menu && is_arrow) {
        step_in_menu(key);
        return std::nullopt;
    }
    const std::size_t count = items_.size();
    const auto step = [&](std::size_t by) {
        if (count > 0) selected_ = (selected_ + by) % count;
        return std::nullopt;
    };
    switch (key) {
        case MenuKey::up:
            return step(count - 1);
        case MenuKey::down:
            return step(1);
        case MenuKey::left:
            if (screen_ == Screen::settings) return adjust(-1);
            return step(count - 1);
        case MenuKey::right:
            if (screen_ == Screen::settings) return adjust(1);
            return step(1);
        case MenuKey::accept:
            return accept();
        case MenuKey::back:
            return back();
    }
    return std::nullopt;
}

void Screens::point_at(std::size_t item)
{
    if (item < items_.size()) selected_ = item;
}

std::optional<Request> Screens::click(std::size_t item, double share)
{
    if (item >= items_.size()) return std::nullopt;
    selected_ = item;
    if (screen_ == Screen::play) return back();
    if (!items_[item].share) return accept();
    set_slider(item, share);
    return Request{Request::Kind::settings};
}

void Screens::set_slider(std::size_t item, double share)
{
    share = std::clamp(share, 0.0, 1.0);
    if (item == kVolume) {
        settings_.volume = std::round(share / kVolumeStep) * kVolumeStep;
    } else {
        const double scale = kSmallestWindow + share * (kLargestWindow - kSmallestWindow);
        settings_.window_scale = std::round(scale / kWindowStep) * kWindowStep;
    }
    settings_ = within_bounds(settings_, backends_);
    list_items();
}

std::optional<Request> Screens::adjust(int direction)
{
    switch (static_cast<Setting>(selected_)) {
        case kVolume:
            set_slider(kVolume, settings_.volume + direction * kVolumeStep);
            break;
        case kMute:
            settings_.mute = !settings_.mute;
            break;
        case kBackend: {
            if (backends_.empty()) return std::nullopt;
            const auto found = std::find(backends_.begin(), backends_.end(), settings_.backend);
            const auto place = static_cast<std::size_t>(found - backends_.begin());
            const std::size_t by = direction > 0 ? 1 : backends_.size() - 1;
            settings_.backend = backends_[(place + by) % backends_.size()];
            break;
        }
        case kFullscreen:
            settings_.fullscreen = !settings_.fullscreen;
            break;
        case kWindowSize:
            set_slider(kWindowSize, window_share(settings_.window_scale + direction * kWindowStep));
            break;
        case kVsync:
            settings_.vsync = !settings_.vsync;
            break;
        case kSettingsBack:
            return std::nullopt;
    }
    list_items();
    return Request{Request::Kind::settings};
}

std::optional<Request> Screens::accept()
{
    switch (screen_) {
        case Screen::menu:
            if (selected_ < modes().size()) return Request{Request::Kind::start, std::string(modes()[selected_].scene)};
            if (selected_ == modes().size())
                show(Screen::scores);
            else if (selected_ == modes().size() + 1)
                show(Screen::settings);
            else
                return Request{Request::Kind::quit};
            return std::nullopt;
        case Screen::play:
            return std::nullopt;
        case Screen::paused:
            if (selected_ == 0) {
                show(Screen::play);
                return Request{Request::Kind::resume};
            }
            if (selected_ == 1) return Request{Request::Kind::restart, scene_};
            if (selected_ == 3) return back();
            show(Screen::settings);
            return std::nullopt;
        case Screen::over:
            if (selected_ == 0) return Request{Request::Kind::restart, scene_};
            if (selected_ + 1 == items_.size()) return back();
            show(Screen::scores);
            return std::nullopt;
        case Screen::scores:
            return back();
        case Screen::settings:
            return selected_ == kSettingsBack ? back() : adjust(1);
    }
    return std::nullopt;
}

std::optional<Request> Screens::back()
{
    switch (screen_) {
        case Screen::menu:
            selected_ = items_.size() - 1;  // Esc is not to end the program by surprise: it chooses "Quit"
            return std::nullopt;
        case Screen::play:
            show(Screen::paused);
            return std::nullopt;
        case Screen::paused:
            // The Esc that came here may be pressed once too often; leaving a game needs the line "Menu".
            if (selected_ != 3) {
                show(Screen::play);
                return Request{Request::Kind::resume};
            }
            show(Screen::menu);
            return Request{Request::Kind::to_menu};
        case Screen::over:
            show(Screen::menu);
            return Request{Request::Kind::to_menu};
        case Screen::scores:
        case Screen::settings:
            show(before_);
            selected_ = std::min(selected_before_, items_.empty() ? 0 : items_.size() - 1);
            return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace kerf::ui
