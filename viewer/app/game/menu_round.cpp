#include "viewer/app/game/menu_round.h"

#include <numeric>
#include <utility>

namespace kerf::app {

namespace {

/// From the choice to the game that begins: time to cut the fruit and to see its juice.
constexpr sim::Tick kChoiceTicks = 78;
/// Who has just swiped need not be shown how.
constexpr sim::Tick kDemoPatience = 240;

RoundSetup with_menu(RoundSetup setup)
{
    setup.scene = std::make_unique<ui::MenuScene>();
    return setup;
}

}  // namespace

MenuRound::MenuRound(RoundSetup setup, std::size_t fruit_models, sound::Speaker& speaker)
    : SimulatedRound(with_menu(std::move(setup)), speaker), fruit_models_(fruit_models)
{
}

void MenuRound::point(const WindowPointer& change, const glm::vec2& size)
{
    SimulatedRound::point(change, size);
    if (blade_input().is_swiping()) touched_at_ = now();
}

/// The fruit is cut as the player would have done it.
void MenuRound::choose(const std::string& scene)
{
    if (!wanted_.empty()) return;
    wanted_ = scene;
    wanted_at_ = now();
    const ui::Mode* const mode = ui::find_mode(scene);
    const glm::dvec2 middle = ui::place_of_mode(static_cast<std::size_t>(mode - ui::modes().data()));
    constexpr int kSamples = 12;
    constexpr sim::Microseconds kStep = 9000;
    for (int i = 0; i <= kSamples; ++i) {
        const double share = 2.0 * double(i) / kSamples - 1.0;
        const auto kind = i == 0          ? sim::InputKind::press
                          : i == kSamples ? sim::InputKind::release
                                          : sim::InputKind::move;
        played().push({simulation()->time() + 1 + i * kStep, kind, middle + share * glm::dvec2(1.7, 0.9), {}});
    }
}

std::string MenuRound::chosen() const
{
    return !wanted_.empty() && now() - wanted_at_ >= kChoiceTicks ? wanted_ : std::string();
}

std::vector<std::size_t> MenuRound::next_models() const
{
    std::vector<std::size_t> models(fruit_models_);
    std::iota(models.begin(), models.end(), std::size_t(0));
    return models;
}

const sim::Blade* MenuRound::demo_blade() const
{
    return wanted_.empty() && !demo_.is_away(*simulation()) ? &demo_.blade() : nullptr;
}

void MenuRound::watch(const RoundFrame& frame)
{
    if (frame.mode && wanted_.empty() && now() - touched_at_ >= kDemoPatience)
        demo_.show_on_menu(*simulation(), *frame.mode);
    if (!menu().chosen() || !wanted_.empty()) return;
    wanted_ = ui::modes()[*menu().chosen()].scene;
    wanted_at_ = now();
}

}  // namespace kerf::app
