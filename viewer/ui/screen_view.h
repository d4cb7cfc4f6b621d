#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viewer/game/game_state.h"
#include "viewer/ui/canvas.h"
#include "viewer/ui/screens.h"

namespace kerf::ui {

/// A line of the list of high scores.
struct ScoreLine
{
    std::int64_t score = 0;
    std::string date;
    bool is_latest = false;  ///< of the game that has just ended
};

/// How one half of a duel that is over did.
struct DuelSide
{
    std::string backend;
    std::size_t cuts = 0;
    double cut_ms = 0.0;          ///< all of them
    double worst_cut_ms = 0.0;    ///< the longest
    double worst_frame_ms = 0.0;  ///< the cuts of one frame
    std::int64_t lost_frames = 0;
};

/// What a screen shows besides its lines.
struct ScreenContent
{
    const game::GameState* game = nullptr;                                    ///< the game that is over; null: none
    std::vector<DuelSide> duel = {};                                          ///< both halves; empty: no duel is over
    std::vector<std::pair<std::string, std::vector<ScoreLine>>> scores = {};  ///< for each mode, best first
    std::string message = {};                                                 ///< at the lower edge; empty: none
    glm::vec2 pointer{-1.0f};                                                 ///< on the picture
};

/// Where the lines of a screen are, so that a pointer can choose them.
struct Hotspot
{
    Box2 box;
    Box2 slider;  ///< empty: none
};

/// Draws the screen that is shown over the stage, and gives the place of each of its lines.
std::vector<Hotspot> show_screen(Canvas& canvas, const Screens& screens, const ScreenContent& content);

/// The line at a place of the picture, and where along its slider.
struct Pointed
{
    std::size_t item = 0;
    double share = 1.0;
};
std::optional<Pointed> item_at(const std::vector<Hotspot>& hotspots, const glm::vec2& place);

/// Where the menu's fruit hang on the stage, in the order of modes(). Metres.
glm::dvec2 place_of_mode(std::size_t mode);
/// How large they are: radius, metres.
inline constexpr double kModeRadius = 1.32;

}  // namespace kerf::ui
