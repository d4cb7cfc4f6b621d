#pragma once

#include <kerf/fracture.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "viewer/sim/body_proxies.h"
#include "viewer/sim/breaking/mesh_ray.h"
#include "viewer/sim/solid.h"

namespace kerf::sim {

/// A piece that is ready to become a body.
struct BrokenPiece
{
    Object object;
    Box box;
    Solid solid;
    CollisionProxy proxy;
    std::uint64_t key = 0;  ///< tells its copy on the graphics card from all others, and from copies in the library
};

/// An object that is taken apart. Whoever asks fills in the first part, and reads the second once it is done.
struct BreakJob
{
    Object object;  ///< given back if there are no pieces
    FractureOptions options;
    /// It strikes where this meets the object, and that is `options.at`; none: at options.at.
    std::optional<MeshRay> ray;
    double scale = 1.0;           ///< metres a mesh unit
    std::uint64_t triangles = 0;  ///< of the object
    ProxyKind proxy = ProxyKind::bounded_hull;

    Status status = Status::done;  ///< of fracture(); `missed`: the ray goes past the object
    std::string reason;            ///< why there are no pieces; empty if there are, or if it missed
    glm::dvec3 at{0.0};            ///< where it was struck, mesh coordinates
    std::vector<BrokenPiece> pieces;
    std::vector<FractureBond> bonds;           ///< of pieces by their numbers, mesh units
    double fracture_ms = 0.0, proxy_ms = 0.0;  ///< wall clock

    std::atomic<bool> is_done = false;
    void wait() { is_done.wait(false); }
};

/// Takes objects apart on a thread of its own, one after another.
class Breaker
{
public:
    Breaker() = default;
    /// Gives up what is under way.
    ~Breaker();
    Breaker(const Breaker&) = delete;
    Breaker& operator=(const Breaker&) = delete;

    void start(std::shared_ptr<BreakJob> job);

private:
    void work();
    void carry_out(BreakJob& job);

    std::mutex mutex_;  ///< of jobs_
    std::condition_variable changed_;
    std::deque<std::shared_ptr<BreakJob>> jobs_;
    std::atomic<bool> is_ending_ = false;
    std::uint64_t pieces_ = 0;  ///< made so far
    std::thread thread_;        ///< begun with the first job
};

}  // namespace kerf::sim
