#include "viewer/duel/duel.h"

#include <algorithm>
#include <utility>

namespace kerf::duel {

Duel::Duel(const std::shared_ptr<sim::ModelLibrary>& models, const sim::Settings& settings,
           const std::array<std::string, 2>& backends, const SceneMaker& make_scene)
{
    blade_.set_gesture(settings.gesture);
    for (std::size_t i = 0; i < halves_.size(); ++i) {
        sim::Settings own = settings;
        own.backend = backends[i];
        halves_[i] = std::make_unique<Half>(models, own, make_scene());
        scores_[i].backend = halves_[i]->simulation().backend();
    }
}

void Duel::follow(const sim::InputEvent& event)
{
    switch (event.kind) {
        case sim::InputKind::press:
            blade_.press(event.time, event.position);
            break;
        case sim::InputKind::move:
            blade_.move(event.time, event.position);
            break;
        case sim::InputKind::release:
            blade_.release(event.time, event.position);
            break;
        case sim::InputKind::command:
            break;
    }
}

void Duel::advance(sim::Tick ticks, const std::vector<sim::InputEvent>& events)
{
    for (const sim::InputEvent& event : events) follow(event);
    now_ += ticks;
    for (const auto& half : halves_) {
        half->owe(ticks, events);
        half->resume(std::max<sim::Tick>(kCatchUp * ticks, 1));
    }
}

void Duel::wait_for(std::chrono::microseconds longest)
{
    const auto end = std::chrono::steady_clock::now() + longest;
    for (const auto& half : halves_) {
        const auto left = end - std::chrono::steady_clock::now();
        half->wait_for(std::max(std::chrono::duration_cast<std::chrono::microseconds>(left), {}));
    }
}

void Duel::finish()
{
    for (const auto& half : halves_) half->resume(half->owed());
    for (const auto& half : halves_) half->finish();
}

void Duel::count(std::size_t i, const sim::CutRecord& cut)
{
    constexpr double kFrameMs = 1e3 * sim::kTickSeconds * double(sim::kTicksPerFrame);
    Score& score = scores_[i];
    score.last_ms = cut.cut_ms + cut.proxy_ms + cut.bodies_ms;
    score.cut_ms += score.last_ms;
    score.worst_ms = std::max(score.worst_ms, score.last_ms);
    ++score.cuts;

    if (cut.frame() != std::exchange(frame_[i], cut.frame())) frame_ms_[i] = 0.0;
    const double before = std::exchange(frame_ms_[i], frame_ms_[i] + score.last_ms);
    score.worst_frame_ms = std::max(score.worst_frame_ms, frame_ms_[i]);
    score.lost_frames += std::int64_t(frame_ms_[i] / kFrameMs) - std::int64_t(before / kFrameMs);
}

Score Duel::score(std::size_t i)
{
    Score& score = scores_[i];
    Half& half = *halves_[i];
    if (half.idle()) {
        const std::vector<sim::CutRecord>& cuts = half.simulation().cuts();
        for (; counted_[i] < cuts.size(); ++counted_[i])
            if (!cuts[counted_[i]].pieces.empty()) count(i, cuts[counted_[i]]);
    }
    score.behind_ms = 1e3 * sim::kTickSeconds * double(now_ - half.done());
    return score;
}

}  // namespace kerf::duel
