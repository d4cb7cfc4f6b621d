#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "viewer/render/fragment_store.h"
#include "viewer/render/scene_renderer.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

/// What bringing the pieces of one cut onto the graphics card cost. Pieces that share buffers are uploaded together:
/// each of several cuts since the last sync() counts the bytes that it made itself, and that share of the time. What
/// was cut again before anybody saw it and has buffers of its own is never uploaded, and counts nothing.
struct CutUpload
{
    double cpu_ms = 0.0;      ///< of this thread; the driver's own threads are not in it
    std::uint64_t bytes = 0;  ///< vertices and indices
};

/// The simulation's bodies on the graphics card. After each batch of ticks sync() uploads what is new and frees what is
/// gone.
///
/// What a cut makes is there at once. What is thrown whole comes bit by bit, kBytesInAFrame each time, and is not drawn
/// before all of it is there; what the scene will throw next (Scene::next_models()) comes ahead of its throw, and the
/// pieces of what is being broken ahead of the moment in which they take its place.
class GpuWorld
{
public:
    /// Of whole objects, in one sync(): a millisecond of copying. A giant of four million triangles takes 28 of them.
    static constexpr std::uint64_t kBytesInAFrame = 4u << 20;

    /// To make buffers takes as long as to copy so much. More small objects than kBytesInAFrame has room for, the pieces of
    /// what breaks, come in several frames.
    static constexpr std::uint64_t kBytesOfBuffers = 64u << 10;

    explicit GpuWorld(render::LookTable& looks) : store_(looks) {}

    /// Once a frame. O(bodies + new bytes). A piece that was cut again before anybody saw it is never uploaded.
    /// @throws render::RenderError  the graphics card has no memory left
    void sync(const sim::Simulation& simulation);

    /// All bodies, `fraction` of a tick after the last one but one. Valid until the next sync().
    std::span<const render::DrawnObject> objects(const sim::Simulation& simulation, double fraction = 1.0);

    /// One for each of Simulation::cuts().
    const std::vector<CutUpload>& cut_uploads() const { return cut_uploads_; }
    /// What was uploaded for no cut: objects as they were thrown, and pieces of what broke. With cut_uploads() this is all that was uploaded.
    std::uint64_t bytes_of_throws() const { return bytes_of_throws_; }
    /// The most that one sync() uploaded of whole objects.
    std::uint64_t most_bytes_of_throws() const { return most_bytes_of_throws_; }
    /// How far the largest object is that is on its way or waits to be thrown, 0 to 1; empty when none does.
    std::optional<double> arriving() const;
    const render::FragmentStore& store() const { return store_; }

private:
    /// What one sync() uploaded into one set of buffers.
    struct Upload
    {
        CutUpload cost;
        std::set<std::size_t, std::greater<>> cuts;  ///< indices, newest first, that may have made it
    };
    using Uploads = std::map<const render::SharedBuffers*, Upload>;

    bool bring(Object& object, std::uint64_t copy, render::Room room = render::Room::to_grow, render::Kin kin = 0);
    render::DrawnFragment add(const sim::Simulation& simulation, sim::Body& body, render::Kin kin = 0);
    void bring_whole_bodies(const sim::Simulation& simulation);
    void bring_next(const sim::Simulation& simulation);
    Uploads upload_new_bodies(const sim::Simulation& simulation, std::size_t first_cut);
    void share_out(const sim::Simulation& simulation, std::size_t first_cut, Uploads& uploads);

    render::FragmentStore store_;
    std::map<sim::ObjectId, render::DrawnFragment> fragments_;
    /// Of whole objects, by the library's number of the copy: those on their way, and those that wait to be thrown.
    std::map<std::uint64_t, render::Arrival> arrivals_;
    std::set<std::uint64_t> wanted_;  ///< arrivals that this sync() has met
    std::uint64_t budget_ = 0;        ///< what is left of it in this sync()
    std::vector<CutUpload> cut_uploads_;
    std::uint64_t bytes_of_throws_ = 0, most_bytes_of_throws_ = 0;
    std::vector<render::DrawnObject> objects_;
};

}  // namespace kerf::app
