#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "viewer/sim/model_library.h"

namespace kerf::game {

/// What a GiantMaker is doing.
enum class GiantStage : std::uint8_t
{
    idle,       ///< nothing was asked for yet
    shaping,    ///< generating triangles
    joining,    ///< welding them into a mesh
    preparing,  ///< by the back end, with a copy to throw
    ready,
    failed,
};
std::string_view name_of(GiantStage stage);

/// Makes asteroids and copies of them on a thread of its own. Everything is put on a ModelLibrary, where the last size
/// stays and earlier ones are emptied. A new request gives up what an earlier one was doing.
class GiantMaker
{
public:
    explicit GiantMaker(std::shared_ptr<sim::ModelLibrary> models) : models_(std::move(models)) {}
    /// Does not wait for a thread that is still at work: what it makes is thrown away.
    ~GiantMaker();
    GiantMaker(const GiantMaker&) = delete;
    GiantMaker& operator=(const GiantMaker&) = delete;

    /// Starts to get a copy ready to throw: the mesh is made when its size or seed are new. Returns at once.
    void request(std::int64_t triangles, std::uint64_t seed, const std::string& backend,
                 sim::ProxyKind proxy = sim::ProxyKind::bounded_hull);

    GiantStage stage() const;
    /// 0 to 1, never falling for one request: the share of the time that is over, by the stage and what it usually
    /// takes.
    double progress() const;
    bool is_done() const { return stage() == GiantStage::ready || stage() == GiantStage::failed; }
    /// Waits until it is done.
    void wait();

    /// Once ready: where it is in the library, with a copy in stock for the back end that was asked for.
    std::size_t model() const;
    /// Once failed: one sentence.
    std::string error() const;

private:
    /// Shared with the thread, which may outlive this.
    struct Task;

    /// Lets the task finish alone. The model that it had made already.
    std::optional<std::size_t> give_up();

    std::shared_ptr<sim::ModelLibrary> models_;
    std::shared_ptr<Task> task_;
    std::thread thread_;
};

}  // namespace kerf::game
