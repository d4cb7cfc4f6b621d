#include "viewer/app/soundtrack.h"

#include <algorithm>
#include <cmath>

#include "viewer/game/game_scene.h"
#include "viewer/sim/camera.h"

namespace kerf::app {

namespace {

using sound::Sound;

double pan_of(double x)
{
    return std::clamp(x / sim::kStageHalfWidth, -1.0, 1.0);
}

/// The same sound is never quite the same: a pitch between 0.9 and 1.1 from a counter.
double varied(std::uint64_t number)
{
    return 0.9 + 0.2 * double(number * 7 % 11) / 10.0;
}

void play(const game::GameEvent& event, sound::Speaker& speaker)
{
    const double pan = pan_of(event.place.x);
    switch (event.kind) {
        case game::GameEventKind::thrown:
            speaker.play(Sound::thud, {0.5, event.fruit == game::FruitKind::bomb ? 0.8 : varied(event.object), pan});
            break;
        case game::GameEventKind::critical:
            speaker.play(Sound::sparkle, {0.9, 1.0, pan});
            break;
        case game::GameEventKind::combo:
            // The longer, the higher: a tone of the scale for each fruit beyond the third.
            speaker.play(Sound::chime, {1.0, std::pow(2.0, std::min(event.count - 3, 7) / 6.0), pan});
            break;
        case game::GameEventKind::life_lost:
            speaker.play(Sound::miss, {1.0, 1.0, pan});
            break;
        case game::GameEventKind::extra_life:
            speaker.play(Sound::extra_life);
            break;
        case game::GameEventKind::bomb:
            speaker.play(Sound::bomb, {1.0, 1.0, pan});
            break;
        case game::GameEventKind::special_started:
            speaker.play(Sound::freeze, {1.0, event.fruit == game::FruitKind::freeze ? 1.0 : 1.26, pan});
            break;
        case game::GameEventKind::game_over:
            speaker.play(Sound::game_over);
            break;
        case game::GameEventKind::wave:
        case game::GameEventKind::fruit_cut:
        case game::GameEventKind::missed:
        case game::GameEventKind::special_ended:
            break;
    }
}

}  // namespace

void Soundtrack::follow(const sim::Simulation& simulation, sound::Speaker& speaker)
{
    const std::vector<sim::CutRecord>& cuts = simulation.cuts();
    for (; cuts_seen_ < cuts.size(); ++cuts_seen_) {
        const sim::CutRecord& cut = cuts[cuts_seen_];
        if (cut.pieces.empty()) continue;
        speaker.play(Sound::splat, {0.9, varied(cut.number), pan_of(cut.centre.x)});
    }
    follow_breaks(simulation, speaker);
    follow_blade(simulation, speaker);
    follow_game(simulation, speaker);
}

/// Fruit that bursts is wet. A crack for a few bonds, a heap that comes down for many; the more, the louder.
void Soundtrack::follow_breaks(const sim::Simulation& simulation, sound::Speaker& speaker)
{
    constexpr std::size_t kHeap = 8;     // parts
    constexpr double kManyBonds = 60.0;  // as loud as it gets
    const std::vector<sim::BreakRecord>& breaks = simulation.breaks();
    for (; breaks_seen_ < breaks.size(); ++breaks_seen_)
        if (game::game_of(simulation.scene()) != nullptr && !breaks[breaks_seen_].pieces.empty())
            speaker.play(Sound::splat, {0.9, varied(breaks_seen_), pan_of(breaks[breaks_seen_].centre.x)});
    const std::vector<sim::CrackRecord>& cracks = simulation.cracks();
    for (; cracks_seen_ < cracks.size(); ++cracks_seen_) {
        const sim::CrackRecord& crack = cracks[cracks_seen_];
        const double pan = pan_of(crack.place.x), share = std::min(1.0, double(crack.bonds) / kManyBonds);
        if (crack.bonds == 0)
            speaker.play(Sound::thud, {0.9, varied(cracks_seen_), pan});
        else
            speaker.play(crack.parts >= kHeap ? Sound::shatter : Sound::crack,
                         {0.45 + 0.55 * std::sqrt(share), varied(cracks_seen_), pan});
    }
}

void Soundtrack::follow_blade(const sim::Simulation& simulation, sound::Speaker& speaker)
{
    constexpr sim::Tick kBetween = sim::kTicksPerSecond / 4;
    const sim::Blade& blade = simulation.blade();
    const double speed = blade.speed(simulation.time());
    if (!blade.pressed() || speed < 2.0 * sim::kSlowestCut || simulation.now() - last_swish_ < kBetween) return;
    last_swish_ = simulation.now();
    speaker.play(Sound::swish, {std::min(1.0, speed / 40.0), std::clamp(speed / 25.0, 0.8, 1.3)});
}

void Soundtrack::follow_game(const sim::Simulation& simulation, sound::Speaker& speaker)
{
    const game::GameScene* const played = game::game_of(simulation.scene());
    if (played == nullptr) return;
    for (; events_seen_ < played->events().size(); ++events_seen_) play(played->events()[events_seen_], speaker);
    bool burns = false;
    for (const auto& body : simulation.bodies()) burns = burns || played->whole(body->id()) == game::FruitKind::bomb;
    speaker.set_fuse(burns && played->state().phase == game::GamePhase::playing);
    if (played->state().seconds_left) {
        const int left = static_cast<int>(std::ceil(*played->state().seconds_left));
        if (left != seconds_told_ && left > 0 && left <= 10) speaker.play(Sound::tick, {0.8, left <= 3 ? 1.5 : 1.0});
        seconds_told_ = left;
    }
}

}  // namespace kerf::app
