#pragma once

#include <array>
#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "viewer/app/game/stage_layout.h"
#include "viewer/app/gpu_world.h"
#include "viewer/app/painter.h"
#include "viewer/duel/duel.h"
#include "viewer/duel/timetable_scene.h"
#include "viewer/ui/canvas.h"

namespace kerf::app {

/// A duel as one sees it: both stages side by side, with what each half has spent on cutting. While the models are
/// being prepared, on a thread of its own, there is a note instead.
class DuelView
{
public:
    /// How much larger a half is shown than the window's shape asks for: the sides of the stage are left out.
    static constexpr float kZoom = 1.4f;
    /// Triangles of the boulder that is thrown between the fruit: large enough to feel a cut that costs all of it.
    static constexpr std::int64_t kBoulder = 160'000;

    /// @param models    with the fruit
    /// @param triangles of the boulder
    /// @param wanted    back ends: both, or one that meets the default; empty: the default and the baseline
    DuelView(std::shared_ptr<sim::ModelLibrary> models, const sim::Settings& settings,
             std::int64_t triangles = kBoulder, const std::vector<std::string>& wanted = {});
    ~DuelView();
    DuelView(const DuelView&) = delete;
    DuelView& operator=(const DuelView&) = delete;

    /// The models are prepared. @throws what went wrong with them
    bool ready();
    /// Waits for that.
    void wait_until_ready();

    /// How far preparing is, 0 to 1, never falling.
    double progress() const { return duel_ ? 1.0 : double(*prepared_) / kSteps; }

    sim::Tick now() const { return duel_ ? duel_->now() : 0; }
    /// Its time is up and both halves have caught up with the clock.
    bool is_over();
    /// How both halves stand.
    std::array<duel::Score, 2> scores();
    /// So many ticks more, with their input; waits for slow cuts only when told to.
    void advance(sim::Tick ticks, const std::vector<sim::InputEvent>& events, bool waits);

    /// Uploads what the halves that are idle have to show. @throws render::RenderError
    void sync(Painter& painter);
    /// Of a picture of this size.
    std::array<StagePicture, 2> stages(int width, int height) const;
    void write(ui::Canvas& canvas);

    /// Where both stages are on a picture.
    static StageLayout layout() { return {2, double(kZoom)}; }

    /// The duel itself; once ready().
    duel::Duel& duel() { return *duel_; }

private:
    /// In preparing: the boulder's shape, then for each back end its mesh and a copy of it.
    static constexpr int kSteps = 5;
    void write_score(ui::Canvas& canvas, std::size_t half);

    std::shared_ptr<sim::ModelLibrary> models_;
    sim::Settings settings_;
    std::int64_t triangles_;
    std::array<std::string, 2> opponents_;
    std::shared_ptr<std::atomic<int>> prepared_;                      ///< of kSteps
    std::future<std::vector<duel::TimetableScene::Item>> preparing_;  ///< gives what is thrown
    std::atomic<bool> ends_ = false;
    std::thread stocking_;  ///< keeps copies of the boulder ready
    std::unique_ptr<duel::Duel> duel_;
    std::array<std::unique_ptr<GpuWorld>, 2> worlds_;
    std::array<effects::Effects, 2> effects_;
    std::array<std::span<const render::DrawnObject>, 2> objects_;  ///< as they were when the half was last idle
};

}  // namespace kerf::app
