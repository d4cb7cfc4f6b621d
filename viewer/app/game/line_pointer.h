#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "viewer/app/window.h"
#include "viewer/ui/screen_view.h"

namespace kerf::app {

/// The mouse on the lines of a screen: which is pointed at, which was pressed, whose slider is moved.
class LinePointer
{
public:
    /// What a change of the pointer meant to the screen.
    struct Answer
    {
        bool is_taken = false;               ///< the rest of the program has nothing to do with it
        std::optional<ui::Request> request;  ///< what a line that was chosen asks for
    };

    void move_to(const glm::vec2& place) { place_ = place; }
    /// On the picture; outside of it before the first move.
    const glm::vec2& place() const { return place_; }

    /// The lines of the screen that is shown are here now.
    void set_lines(std::vector<ui::Hotspot> lines, const ui::Screens& screens);
    const std::vector<ui::Hotspot>& lines() const { return lines_; }
    /// A line of the screen as it was written; none when another one is shown since.
    std::optional<ui::Pointed> line_at(const glm::vec2& place, const ui::Screens& screens) const;

    /// On a menu. @param is_swiping  the button is down for a swipe: lines that it crosses are not pointed at
    Answer point(const WindowPointer& change, ui::Screens& screens, bool is_swiping);
    /// What was pressed is chosen no more.
    void forget_press() { pressed_.reset(); }

private:
    std::vector<ui::Hotspot> lines_;
    std::uint64_t lines_of_ = 0;  ///< the screen they belong to, as Screens counts them
    glm::vec2 place_{-1.0f};
    std::optional<std::size_t> sliding_;  ///< the line whose slider is being moved
    /// The screen as Screens counts them, and the line on it that is chosen when the button is let go there.
    std::optional<std::pair<std::uint64_t, std::size_t>> pressed_;
};

}  // namespace kerf::app
