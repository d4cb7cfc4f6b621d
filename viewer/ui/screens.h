#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/game/stored_settings.h"

namespace kerf::ui {

/// What is on the picture besides the stage.
enum class Screen
{
    menu,
    play,
    paused,
    over,  ///< the game has ended
    scores,
    settings,
};

/// "menu", "paused", ...: for the command line. Empty for a name that is none.
std::optional<Screen> find_screen(std::string_view name);
const std::vector<std::string>& screen_names();

/// What the arrow keys and their like mean in a menu.
enum class MenuKey
{
    up,
    down,
    left,
    right,
    accept,
    back,
};

/// A line of a menu.
struct MenuItem
{
    std::string label;
    std::string value = {};            ///< what is chosen, for lines that have a choice
    std::optional<double> share = {};  ///< 0 to 1, for lines with a slider
};

/// What the player asked for.
struct Request
{
    enum class Kind
    {
        start,    ///< a scene
        resume,   ///< the game that is paused
        restart,  ///< the same scene again
        to_menu,
        quit,
        settings,  ///< they have changed
    } kind = Kind::start;
    std::string scene = {};

    friend bool operator==(const Request&, const Request&) = default;
};

/// Of the window, in 1280x720.
inline constexpr double kSmallestWindow = 0.5, kLargestWindow = 3.0;

/// Something that can be played.
struct Mode
{
    std::string_view scene;
    std::string_view title;
    std::string_view promise;  ///< a few words
    std::string_view model;    ///< what stands for it on the menu's stage
};
const std::vector<Mode>& modes();
/// Null for a scene that is not in the menu.
const Mode* find_mode(std::string_view scene);

/// Which screen is shown, what can be chosen on it and what follows from a choice. All of it works with keys alone; a
/// pointer does the same by choosing a line. While a game is played there is one line, the button that pauses it: no
/// key chooses it, Esc does the same. It knows nothing of windows and drawing.
class Screens
{
public:
    /// @param backends  that can be chosen, the default first
    Screens(game::StoredSettings settings, std::vector<std::string> backends);

    Screen screen() const { return screen_; }
    /// Grows whenever another screen is shown, or the same one anew: whoever remembers where its lines are sees by it
    /// that they are others now.
    std::uint64_t shown() const { return shown_; }
    /// Goes to a screen as the program sees fit: the game is over, the window lost its focus.
    void show(Screen screen);
    /// A game of this scene has begun: the settings remember it, and the menu will choose it.
    void play(std::string scene);
    const std::string& scene() const { return scene_; }
    /// A game is under way behind this screen and stands still.
    bool holds_game() const;

    const std::vector<MenuItem>& items() const { return items_; }
    std::size_t selected() const { return selected_; }
    const game::StoredSettings& settings() const { return settings_; }
    void set_settings(const game::StoredSettings& settings);

    /// What follows, if anything does; the screen has changed already. The menu has two rows, the games and what lies
    /// below them: Up and Down go from one to the other, Left and Right along one. Elsewhere lines are one below
    /// another.
    std::optional<Request> press(MenuKey key);
    /// The pointer is over a line, or has left for none.
    void point_at(std::size_t item);
    /// The pointer has pressed a line.
    /// @param share  where along a slider, 0 to 1
    std::optional<Request> click(std::size_t item, double share = 1.0);

private:
    std::optional<Request> accept();
    std::optional<Request> back();
    std::optional<Request> adjust(int direction);
    void step_in_menu(MenuKey key);
    void set_slider(std::size_t item, double share);
    void list_items();
    std::size_t last_played() const;

    game::StoredSettings settings_;
    std::vector<std::string> backends_;
    Screen screen_ = Screen::menu;
    std::uint64_t shown_ = 1;
    Screen before_ = Screen::menu;     ///< where settings and scores were asked for
    std::size_t selected_before_ = 0;  ///< the line there that did
    std::string scene_;                ///< that is played, or was
    std::vector<MenuItem> items_;
    std::size_t selected_ = 0;
    std::size_t column_ = 0;  ///< of the menu: the game that was chosen last
};

}  // namespace kerf::ui
