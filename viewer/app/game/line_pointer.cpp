#include "viewer/app/game/line_pointer.h"

namespace kerf::app {

void LinePointer::set_lines(std::vector<ui::Hotspot> lines, const ui::Screens& screens)
{
    lines_ = std::move(lines);
    lines_of_ = screens.shown();
}

std::optional<ui::Pointed> LinePointer::line_at(const glm::vec2& place, const ui::Screens& screens) const
{
    if (lines_of_ != screens.shown()) return std::nullopt;
    return ui::item_at(lines_, place);
}

/// A slider follows at once; other lines are chosen by pressing and letting go, so that no swipe across chooses.
LinePointer::Answer LinePointer::point(const WindowPointer& change, ui::Screens& screens, bool is_swiping)
{
    using Kind = WindowPointer::Kind;
    const std::optional<ui::Pointed> pointed = line_at(glm::vec2(change.position), screens);
    const auto pressed = change.kind == Kind::move ? pressed_ : std::exchange(pressed_, std::nullopt);
    if (change.kind == Kind::release) sliding_.reset();
    if (!pointed) return {pressed_.has_value(), std::nullopt};

    if (change.kind == Kind::move && !is_swiping) screens.point_at(pointed->item);
    if (change.kind == Kind::press) {
        if (screens.items()[pointed->item].share)
            sliding_ = pointed->item;
        else
            pressed_.emplace(screens.shown(), pointed->item);
    }
    const bool slides = change.kind != Kind::release && sliding_ == pointed->item;
    const bool chooses = change.kind == Kind::release && pressed == std::pair(screens.shown(), pointed->item);
    if (slides || chooses) return {true, screens.click(pointed->item, pointed->share)};
    return {pressed_.has_value(), std::nullopt};
}

}  // namespace kerf::app
