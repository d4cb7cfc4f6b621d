#include "viewer/app/drawn_world.h"

#include "common/cpu_stopwatch.h"

namespace kerf::app {

void DrawnWorld::sync(const sim::Simulation& simulation)
{
    const std::vector<sim::CutRecord>& cuts = simulation.cuts();
    for (std::size_t i = cut_uploads_.size(); i < cuts.size(); ++i)
        for (const sim::PieceRecord& piece : cuts[i].pieces) cut_of_piece_[piece.id] = i;
    cut_uploads_.resize(cuts.size());

    for (const auto& body : simulation.bodies()) {
        if (fragments_.contains(body->id())) continue;
        const bool is_whole = body->identity().parent == 0;
        CpuStopwatch watch;
        const std::uint64_t before = store_.bytes_uploaded();
        fragments_[body->id()] = store_.add(body->object(), is_whole ? render::Room::to_grow : render::Room::exact);
        if (const auto cut = cut_of_piece_.find(body->id()); cut != cut_of_piece_.end()) {
            cut_uploads_[cut->second].cpu_ms += 1e3 * watch.lap();
            cut_uploads_[cut->second].bytes += store_.bytes_uploaded() - before;
        }
    }
    cut_of_piece_.clear();

    // Fragments of what was cut go last: their pieces have taken over the buffers by now.
    std::erase_if(fragments_, [&](const auto& entry) { return simulation.world().find(entry.first) == nullptr; });
    store_.release_unused();
}

std::span<const render::DrawnObject> DrawnWorld::objects(const sim::Simulation& simulation, double fraction)
{
    objects_.clear();
    for (const auto& body : simulation.bodies()) {
        const auto found = fragments_.find(body->id());
        if (found == fragments_.end()) continue;
        const double size = 2.0 * body->identity().origin.radius;
        objects_.push_back({static_cast<std::uint32_t>(body->id()), &found->second,
                            glm::mat4(body->model_matrix(fraction)), static_cast<float>(1.0 / size)});
    }
    return objects_;
}

}  // namespace kerf::app
