#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <vector>

#include "viewer/render/fragment_store.h"
#include "viewer/render/scene_renderer.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

/// What bringing the pieces of one cut onto the graphics card cost. Where several cuts between two calls of sync() were
/// made in the same buffers, the first of them to be uploaded counts for all.
struct CutUpload
{
    double cpu_ms = 0.0;      ///< of this thread; the driver's own threads are not in it
    std::uint64_t bytes = 0;  ///< vertices and indices
};

/// The simulation's bodies on the graphics card. After each batch of ticks sync() uploads what is new and frees what is
/// gone.
class DrawnWorld
{
public:
    explicit DrawnWorld(render::LookTable& looks) : store_(looks) {}

    /// O(bodies + new bytes). A piece that was cut again before anybody saw it is never uploaded.
    /// @throws render::RenderError  the graphics card has no memory left
    void sync(const sim::Simulation& simulation);

    /// All bodies, `fraction` of a tick after the last one but one. Valid until the next sync().
    std::span<const render::DrawnObject> objects(const sim::Simulation& simulation, double fraction = 1.0);

    /// One for each of Simulation::cuts().
    const std::vector<CutUpload>& cut_uploads() const { return cut_uploads_; }
    const render::FragmentStore& store() const { return store_; }

private:
    render::FragmentStore store_;
    std::map<sim::ObjectId, render::DrawnFragment> fragments_;
    std::map<sim::ObjectId, std::size_t> cut_of_piece_;  ///< of pieces not uploaded yet: index of their cut
    std::vector<CutUpload> cut_uploads_;
    std::vector<render::DrawnObject> objects_;
};

}  // namespace kerf::app
