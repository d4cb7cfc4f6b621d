#pragma once

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "viewer/sim/simulation.h"

namespace kerf::duel {

/// One side of a duel: a simulation with a thread of its own, on which its physics and its cuts run. It is given ticks
/// to do and the input that belongs to them; whoever watches looks when it is idle, and never waits for it. What it
/// does depends on ticks and input alone, not on when it got to do them.
///
/// All functions are for one other thread, the one that watches.
class Half
{
public:
    /// @throws std::invalid_argument  as Simulation
    Half(std::shared_ptr<sim::ModelLibrary> models, sim::Settings settings, std::unique_ptr<sim::Scene> scene);
    /// Waits for the tick under way.
    ~Half();
    Half(const Half&) = delete;
    Half& operator=(const Half&) = delete;

    /// Lets the half do so many more ticks, when it gets to it.
    /// @param events  of these ticks, in order
    void owe(sim::Tick ticks, const std::vector<sim::InputEvent>& events = {});

    /// It has handed in its work and begins no new one before resume().
    /// @throws what the simulation threw
    bool idle();
    /// Begins with what it owes, at most `most` ticks of it, unless that is nothing or it is not idle.
    void resume(sim::Tick most);
    /// Waits until it is idle, but no longer. Says whether it is. @throws what the simulation threw
    bool wait_for(std::chrono::microseconds longest);
    /// Does everything that it owes, and waits for it. @throws what the simulation threw
    void finish();

    /// Ticks done, and ticks to do.
    sim::Tick done();
    sim::Tick owed();

    /// Only while idle.
    const sim::Simulation& simulation() const { return simulation_; }

private:
    void work();
    void rethrow();

    sim::Simulation simulation_;
    std::vector<sim::InputEvent> input_;  ///< not yet handed to the simulation; the watcher's
    sim::Tick owed_ = 0;                  ///< the watcher's, without what is under way

    std::mutex mutex_;
    std::condition_variable changed_;
    sim::Tick under_way_ = 0;  ///< guarded: ticks that the thread is to do now
    sim::Tick done_ = 0;       ///< guarded
    bool ends_ = false;        ///< guarded
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace kerf::duel
