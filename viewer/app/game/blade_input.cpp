#include "viewer/app/game/blade_input.h"

#include <utility>

#include "viewer/sim/camera.h"
#include "viewer/ui/hud.h"

namespace kerf::app {

void BladeInput::hold(ui::BladeKey key, bool is_down)
{
    if (!is_down || !is_swiping_) keyboard_.hold(key, is_down);
}

void BladeInput::point(const WindowPointer& change, const glm::vec2& size)
{
    using Kind = WindowPointer::Kind;
    const glm::vec2 place(change.position);
    const bool is_press = change.kind == Kind::press;
    if (!is_press && keyboard_.is_cutting()) return;
    if (is_press) {
        if (keyboard_.is_cutting()) changes_.push_back({sim::PointerChange::Kind::release, keyboard_.place()});
        keyboard_.put_away();
    }
    // A swipe that leaves its stage goes on beside it: in another it would begin at the far edge.
    if (is_press || !is_swiping_) stage_ = layout_.stage_at(place, size);
    const ui::Box2 box = layout_.box(stage_, size);
    const glm::dvec2 extent(box.size());
    if (extent.x < 1.0 || extent.y < 1.0) return;
    if (change.kind != Kind::move) is_swiping_ = is_press;
    const sim::Camera camera(extent.x / extent.y);
    changes_.push_back(
        {kind_of(change.kind), camera.screen_to_stage(glm::dvec2(place - box.low), extent) / layout_.zoom});
}

/// What the keys do goes the way of the mouse, so that recordings and rules know no difference.
void BladeInput::steer(double seconds, const glm::vec2& size)
{
    if (!keyboard_.is_shown()) return;
    const glm::dvec2 extent(layout_.box(0, size).size());
    const sim::Camera camera(extent.x / extent.y);
    const glm::dvec2 reach = camera.ndc_to_stage({0.96, 0.95}) / layout_.zoom;  // the cross is seen whole
    for (const sim::PointerChange& change : keyboard_.advance(seconds, reach)) changes_.push_back(change);
}

void BladeInput::release_keys()
{
    if (keyboard_.is_cutting()) changes_.push_back({sim::PointerChange::Kind::release, keyboard_.place()});
    keyboard_.let_go();
}

void BladeInput::let_go()
{
    sampler_.let_go();
    changes_.clear();
    keyboard_.let_go();
    is_swiping_ = false;
}

std::vector<sim::InputEvent> BladeInput::take(sim::Microseconds start, sim::Microseconds end)
{
    return sampler_.frame(start, end, std::exchange(changes_, {}));
}

void BladeInput::write(ui::Canvas& canvas) const
{
    if (!keyboard_.is_shown()) return;
    for (std::size_t stage = 0; stage < layout_.stages; ++stage)
        canvas.cross(ui::on_picture(layout_.zoom * keyboard_.place(), layout_.box(stage, canvas.size())),
                     keyboard_.is_cutting());
}

}  // namespace kerf::app
