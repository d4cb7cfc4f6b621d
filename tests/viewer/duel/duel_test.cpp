#include "viewer/duel/duel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <semaphore>
#include <stdexcept>
#include <thread>
#include <utility>

#include "viewer/duel/timetable_scene.h"
#include "viewer/sim/back_ends.h"
#include "viewer/support/stages.h"

namespace kerf::test {

using duel::Duel;
using duel::TimetableScene;
using namespace std::chrono_literals;

namespace {

const std::array<std::string, 2> kBackEnds{sim::backend_names().front(), "baseline/remap"};

std::unique_ptr<sim::Scene> timetable()
{
    return std::make_unique<TimetableScene>(std::vector<TimetableScene::Item>{{0}});
}

/// As a timetable, but each cut takes half a second longer, in the tick in which it happens.
class SlowCuts : public TimetableScene
{
public:
    using TimetableScene::TimetableScene;
    void on_cut(sim::Simulation&, const sim::CutRecord& cut) override
    {
        if (!cut.pieces.empty()) std::this_thread::sleep_for(500ms);
    }
};

/// As a timetable, but the first cut says when it has begun, and ends once it is let.
class ACutThatWaits : public TimetableScene
{
public:
    ACutThatWaits(std::binary_semaphore& began, std::binary_semaphore& may_end)
        : TimetableScene(std::vector<Item>{{0}}), began_(began), may_end_(may_end)
    {
    }
    void on_cut(sim::Simulation&, const sim::CutRecord& cut) override
    {
        if (cut.pieces.empty() || !std::exchange(first_, false)) return;
        began_.release();
        may_end_.acquire();
    }

private:
    std::binary_semaphore &began_, &may_end_;
    bool first_ = true;
};

/// Lets a cut end, at the latest when a test is left.
class MayEnd
{
public:
    explicit MayEnd(std::binary_semaphore& gate) : gate_(gate) {}
    ~MayEnd() { now(); }
    MayEnd(const MayEnd&) = delete;
    MayEnd& operator=(const MayEnd&) = delete;

    void now()
    {
        if (!std::exchange(is_open_, true)) gate_.release();
    }

private:
    std::binary_semaphore& gate_;
    bool is_open_ = false;
};

/// A duel with another scene for its second half.
Duel unfair_duel(const std::shared_ptr<sim::ModelLibrary>& models,
                 const std::function<std::unique_ptr<sim::Scene>()>& second)
{
    int made = 0;
    return {models, {}, kBackEnds, [&] { return made++ == 0 ? timetable() : second(); }};
}

/// A duel whose second half is slowed down.
Duel unfair_duel(const std::shared_ptr<sim::ModelLibrary>& models)
{
    return unfair_duel(models, [] { return std::make_unique<SlowCuts>(std::vector<TimetableScene::Item>{{0}}); });
}

/// A swipe across the stage when the first throw is near its apex.
std::vector<sim::InputEvent> one_swipe()
{
    return stroke(2'150'000, 100'000, {-6.5, 1.7}, {6.5, 1.9});
}

std::vector<sim::InputEvent> between(const std::vector<sim::InputEvent>& all, sim::Tick from, sim::Tick to)
{
    std::vector<sim::InputEvent> some;
    for (const sim::InputEvent& event : all)
        if (sim::tick_of(event.time) > from && sim::tick_of(event.time) <= to) some.push_back(event);
    return some;
}

}  // namespace

TEST(Duel, ASlowCutFreezesOnlyItsOwnHalf)
{
    const auto models = library_of({"icosphere"});
    for (const std::string& backend : kBackEnds) models->prepare(0, backend);
    std::binary_semaphore began{0}, may_end{0};
    Duel duel = unfair_duel(models, [&] { return std::make_unique<ACutThatWaits>(began, may_end); });
    MayEnd cut_may_end(may_end);
    const std::vector<sim::InputEvent> swipe = one_swipe();

    bool is_cutting = false;
    sim::Tick most_behind_fast = 0;
    for (int frame = 0; frame < 240; ++frame) {
        duel.advance(2, between(swipe, duel.now(), duel.now() + 2));
        // As in play, but for as long as it takes: other programs may want the processor, too.
        ASSERT_TRUE(duel.half(0).wait_for(10s)) << "frame " << frame;
        most_behind_fast = std::max(most_behind_fast, duel.now() - duel.half(0).done());
        // The fast half is drawn in every frame: it has done all ticks, one after the other.
        ASSERT_EQ(duel.half(0).simulation().now(), duel.now());
        while (!is_cutting && !duel.half(1).idle()) is_cutting = began.try_acquire_for(1ms);
    }
    EXPECT_EQ(most_behind_fast, 0);
    EXPECT_TRUE(is_cutting);
    EXPECT_GT(duel.now() - duel.half(1).done(), 20) << "the other half stands still while it cuts";
    cut_may_end.now();
    duel.finish();
    EXPECT_GE(duel.half(0).simulation().cuts().size(), 1u);
    EXPECT_EQ(duel.half(1).simulation().cuts().size(), duel.half(0).simulation().cuts().size());
}

TEST(Duel, ThePiecesOfTheSlowHalfComeLaterAndAreTheSame)
{
    const auto models = library_of({"icosphere"});
    Duel unfair = unfair_duel(models);
    Duel fair(models, {}, kBackEnds, timetable);
    for (Duel* duel : {&unfair, &fair}) {
        for (int frame = 0; frame < 140; ++frame) duel->advance(2, between(one_swipe(), duel->now(), duel->now() + 2));
        duel->finish();
    }
    ASSERT_GE(fair.half(1).simulation().cuts().size(), 1u);
    EXPECT_EQ(unfair.half(1).simulation().state_hash(), fair.half(1).simulation().state_hash());
    EXPECT_EQ(unfair.half(0).simulation().state_hash(), fair.half(0).simulation().state_hash());
}

TEST(Duel, ItsHalvesDoWhatASimulationAloneDoes)
{
    const auto models = library_of({"icosphere"});
    Duel duel(models, {}, kBackEnds, timetable);
    for (int frame = 0; frame < 150; ++frame) duel.advance(2, between(one_swipe(), duel.now(), duel.now() + 2));
    duel.finish();
    for (std::size_t i = 0; i < 2; ++i) {
        sim::Settings settings;
        settings.backend = kBackEnds[i];
        sim::Simulation alone(models, settings, timetable());
        alone.push(one_swipe());
        alone.advance(300);
        EXPECT_EQ(duel.half(i).simulation().state_hash(), alone.state_hash()) << kBackEnds[i];
    }
}

TEST(Duel, BothHalvesCutTheSameAndCountTheirOwnTime)
{
    const auto models = library_of({"asteroid"}, 4000);
    Duel duel(models, {}, kBackEnds, timetable);
    for (int frame = 0; frame < 150; ++frame) duel.advance(2, between(one_swipe(), duel.now(), duel.now() + 2));
    duel.finish();
    const auto &ours = duel.half(0).simulation().cuts(), &theirs = duel.half(1).simulation().cuts();
    ASSERT_GE(ours.size(), 1u);
    EXPECT_EQ(theirs.size(), ours.size());
    EXPECT_EQ(theirs[0].tick, ours[0].tick);
    EXPECT_EQ(theirs[0].statistics.crossing_surface, ours[0].statistics.crossing_surface);
    for (std::size_t i = 0; i < 2; ++i) {
        const duel::Score score = duel.score(i);
        EXPECT_EQ(score.backend, kBackEnds[i]);
        EXPECT_GE(score.cuts, 1u);
        EXPECT_GT(score.cut_ms, 0.0);
        EXPECT_GE(score.cut_ms, score.worst_ms);
        EXPECT_GE(score.worst_ms, score.last_ms);
        EXPECT_EQ(score.behind_ms, 0.0);
        EXPECT_GE(score.worst_frame_ms, score.worst_ms);
        EXPECT_LE(score.worst_frame_ms, score.cut_ms * (1.0 + 1e-12));
        // All that was lost went by in frames of 1/60 s.
        EXPECT_GE(score.lost_frames, 0);
        EXPECT_LE(double(score.lost_frames), score.cut_ms * 60e-3);
        EXPECT_GE(double(score.lost_frames), std::floor(score.worst_frame_ms * 60e-3 - 1e-9));
    }
}

TEST(Duel, TheBladeFollowsThePlayerWhateverTheHalvesDo)
{
    const auto models = library_of({"icosphere"});
    Duel duel = unfair_duel(models);
    duel.advance(2, {{1000, sim::InputKind::press, {-1.0, 0.0}, {}}, {9000, sim::InputKind::move, {1.0, 0.0}, {}}});
    EXPECT_TRUE(duel.blade().pressed());
    EXPECT_EQ(duel.blade().trail(duel.time()).size(), 2u);
}

TEST(Duel, EndsInTheMiddleOfACut)
{
    const auto models = library_of({"icosphere"});
    std::binary_semaphore began{0}, may_end{0};
    Duel duel = unfair_duel(models, [&] { return std::make_unique<ACutThatWaits>(began, may_end); });
    MayEnd cut_may_end(may_end);
    for (int frame = 0; frame < 140; ++frame) duel.advance(2, between(one_swipe(), duel.now(), duel.now() + 2));
    // Until the second half is in the middle of its cut: leaving must neither hang nor crash.
    while (!began.try_acquire_for(1ms)) {
        ASSERT_TRUE(duel.half(1).owed() > 0 || !duel.half(1).idle()) << "it came to its end without a cut";
        duel.half(1).resume(duel.half(1).owed());
    }
    EXPECT_FALSE(duel.half(1).idle());
    cut_may_end.now();
}

TEST(Duel, HandsOnWhatGoesWrongInAHalf)
{
    class Failing : public TimetableScene
    {
    public:
        using TimetableScene::TimetableScene;
        void tick(sim::Simulation&) override { throw std::runtime_error("the scene broke"); }
    };
    Duel duel(library_of({"icosphere"}), {}, kBackEnds,
              [] { return std::make_unique<Failing>(std::vector<TimetableScene::Item>{{0}}); });
    duel.advance(2, {});
    EXPECT_THROW(duel.finish(), std::runtime_error);
}

}  // namespace kerf::test
