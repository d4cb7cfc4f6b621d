#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "viewer/game/giant_maker.h"
#include "viewer/game/giant_sizes.h"
#include "viewer/sim/readiness.h"
#include "viewer/sim/scene.h"

namespace kerf::game {

/// All that a display shows of the scene.
struct GiantState
{
    std::int64_t triangles = 0;  ///< asked for
    GiantStage stage = GiantStage::idle;
    double progress = 0.0;     ///< 0 to 1
    bool is_expected = false;  ///< it was asked for and has not appeared yet
    bool is_held = false;      ///< a giant is there to be cut
    std::uint64_t giants = 0;  ///< so far, this one included
};

/// An asteroid of as many triangles as one likes, held before the camera, slowly turning, to be cut again and again.
/// The heaviest piece is held, the others sink. When little is left of it, or after `next`, the next one rises.
///
/// Commands: `size N` asks for another number of triangles, `next` for a new asteroid, `show`: see
/// sim::Readiness.
class GiantScene : public sim::Scene
{
public:
    static constexpr std::int64_t kTriangles = 100'000;  ///< when nobody asks for another number

    GiantScene(std::shared_ptr<sim::ModelLibrary> models, sim::Readiness readiness);

    std::string_view name() const override { return "giant"; }
    double gravity() const override;
    void tick(sim::Simulation& simulation) override;
    void on_cut(sim::Simulation& simulation, const sim::CutRecord& cut) override;
    void on_gone(sim::Simulation& simulation, const sim::Body& body) override;
    bool command(sim::Simulation& simulation, std::string_view verb, std::string_view argument) override;
    /// A giant that is ready and not yet shown: it is brought onto the graphics card meanwhile.
    std::vector<std::size_t> next_models() const override;
    void hash(sim::StateHash& hash) const override;

    GiantState state() const;

private:
    void request(sim::Simulation& simulation);
    bool may_show(const sim::Simulation& simulation) const;
    void show(sim::Simulation& simulation);
    void hold(sim::Simulation& simulation);

    GiantMaker maker_;
    sim::Readiness readiness_;
    std::int64_t triangles_ = kTriangles;
    std::string backend_;        ///< that the last request was for
    bool is_expected_ = false;   ///< a giant was asked for and is not there yet
    bool is_announced_ = false;  ///< the command to show it is on its way
    bool is_wanted_ = true;      ///< one is to be asked for in the next tick
    sim::ObjectId held_ = 0;     ///< 0: nothing
    double whole_mass_ = 0.0;    ///< of the giant when it appeared, kg
    std::uint64_t giants_ = 0;
};

/// The scene if it is this one; null otherwise.
const GiantScene* giant_of(const sim::Scene& scene);

}  // namespace kerf::game
