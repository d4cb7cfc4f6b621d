#include "viewer/app/gpu_world.h"

#include <algorithm>

#include "common/support/cpu_stopwatch.h"

namespace kerf::app {

namespace {

/// How many pieces there are of each object that broke.
using Siblings = std::map<sim::ObjectId, std::size_t>;

/// Many siblings are drawn together.
render::Kin kin_of(sim::ObjectId parent, const Siblings& siblings)
{
    const auto found = siblings.find(parent);
    return found != siblings.end() && found->second >= render::Swarm::kFewestMembers ? parent : 0;
}

}  // namespace

void GpuWorld::sync(const sim::Simulation& simulation)
{
    const std::size_t first_cut = cut_uploads_.size();
    cut_uploads_.resize(simulation.cuts().size());
    Uploads uploads = upload_new_bodies(simulation, first_cut);
    share_out(simulation, first_cut, uploads);

    const std::uint64_t before = bytes_of_throws_;
    budget_ = kBytesInAFrame;
    wanted_.clear();
    bring_whole_bodies(simulation);
    bring_next(simulation);
    std::erase_if(arrivals_, [&](const auto& entry) { return !wanted_.contains(entry.first); });
    most_bytes_of_throws_ = std::max(most_bytes_of_throws_, bytes_of_throws_ - before);

    // Fragments of what was cut go last: their pieces have taken over the buffers by now.
    std::erase_if(fragments_, [&](const auto& entry) { return simulation.world().find(entry.first) == nullptr; });
    store_.release_unused();
}

/// Brings an object nearer as far as this frame's budget goes. True once all of it is there.
bool GpuWorld::bring(Object& object, std::uint64_t copy, render::Room room, render::Kin kin)
{
    wanted_.insert(copy);
    render::Arrival& arrival = arrivals_[copy];
    if (!arrival.is_whole && budget_ > 0) {
        const std::uint64_t bytes = store_.bring(object, arrival, budget_, room, kin);
        budget_ -= std::min(budget_, std::max(bytes, kBytesOfBuffers));
        bytes_of_throws_ += bytes;
    }
    return arrival.is_whole;
}

render::DrawnFragment GpuWorld::add(const sim::Simulation& simulation, sim::Body& body, render::Kin kin)
{
    const std::vector<std::string>& images = simulation.models().model(body.identity().origin.model).images;
    return store_.add(body.object(), images, render::Room::exact, kin);
}

void GpuWorld::bring_whole_bodies(const sim::Simulation& simulation)
{
    for (const auto& body : simulation.bodies()) {
        const sim::Identity& identity = body->identity();
        if (identity.parent != 0 || body->object().is_empty() || fragments_.contains(body->id())) continue;
        if (bring(body->object(), identity.origin.copy)) fragments_[body->id()] = add(simulation, *body);
    }
}

void GpuWorld::bring_next(const sim::Simulation& simulation)
{
    for (const std::size_t model : simulation.scene().next_models())
        if (const auto next = simulation.models().stocked(model, simulation.backend()))
            bring(*next->object, next->copy);
    const std::vector<sim::WaitingPiece> waiting = simulation.waiting_pieces();
    Siblings siblings;
    for (const sim::WaitingPiece& piece : waiting) ++siblings[piece.parent];
    for (const sim::WaitingPiece& piece : waiting)
        bring(*piece.object, piece.key, render::Room::exact, kin_of(piece.parent, siblings));
}

std::optional<double> GpuWorld::arriving() const
{
    const render::Arrival* largest = nullptr;
    for (const auto& [copy, arrival] : arrivals_)
        if (largest == nullptr || arrival.bytes > largest->bytes) largest = &arrival;
    return largest == nullptr ? std::nullopt : std::optional(largest->share());
}

GpuWorld::Uploads GpuWorld::upload_new_bodies(const sim::Simulation& simulation, std::size_t first_cut)
{
    std::map<sim::ObjectId, std::size_t> cut_of_piece;
    for (std::size_t i = first_cut; i < simulation.cuts().size(); ++i)
        for (const sim::PieceRecord& piece : simulation.cuts()[i].pieces) cut_of_piece[piece.id] = i;

    std::vector<sim::Body*> fresh;
    Siblings siblings;
    for (const auto& body : simulation.bodies()) {
        if (body->identity().parent == 0 || body->object().is_empty() || fragments_.contains(body->id())) continue;
        fresh.push_back(body.get());
        if (!cut_of_piece.contains(body->id())) ++siblings[body->identity().parent];
    }
    Uploads uploads;
    for (sim::Body* const body : fresh) {
        core::CpuStopwatch watch;
        const std::uint64_t before = store_.bytes_uploaded();
        const auto cut = cut_of_piece.find(body->id());
        const render::Kin kin = kin_of(body->identity().parent, siblings);
        render::DrawnFragment& fragment = fragments_[body->id()] = add(simulation, *body, kin);
        const double cpu_ms = 1e3 * watch.lap();
        Upload& upload = uploads[fragment.buffers.get()];
        upload.cost.cpu_ms += cpu_ms;
        upload.cost.bytes += store_.bytes_uploaded() - before;
        if (cut != cut_of_piece.end()) upload.cuts.insert(cut->second);
    }
    // A cut of which nothing is left, all pieces having been cut again, was made where those cuts were made.
    for (std::size_t i = simulation.cuts().size(); i-- > first_cut;) {
        const auto parent = cut_of_piece.find(simulation.cuts()[i].object);
        if (parent == cut_of_piece.end()) continue;
        for (auto& [buffers, upload] : uploads)
            if (upload.cuts.contains(i)) upload.cuts.insert(parent->second);
    }
    return uploads;
}

void GpuWorld::share_out(const sim::Simulation& simulation, std::size_t first_cut, Uploads& uploads)
{
    // Each cut takes what it said that it made. The newest first: where pieces have buffers of their own, what an
    // earlier cut made of a piece that was cut again is gone, and must not be counted out of what the later one made.
    std::vector<std::uint64_t> wanted;
    for (std::size_t i = first_cut; i < simulation.cuts().size(); ++i)
        wanted.push_back(simulation.cuts()[i].statistics.bytes_to_upload);
    for (const auto& [buffers, upload] : uploads) {
        std::uint64_t rest = upload.cost.bytes;
        for (const std::size_t cut : upload.cuts) {
            const std::uint64_t bytes = std::min(rest, wanted[cut - first_cut]);
            wanted[cut - first_cut] -= bytes;
            rest -= bytes;
            cut_uploads_[cut].bytes += bytes;
            if (upload.cost.bytes > 0)
                cut_uploads_[cut].cpu_ms += upload.cost.cpu_ms * double(bytes) / double(upload.cost.bytes);
        }
        bytes_of_throws_ += rest;
    }
}

std::span<const render::DrawnObject> GpuWorld::objects(const sim::Simulation& simulation, double fraction)
{
    objects_.clear();
    for (const auto& body : simulation.bodies()) {
        const auto found = fragments_.find(body->id());
        if (found == fragments_.end()) continue;
        const sim::Origin& origin = body->identity().origin;
        const double size = 2.0 * origin.radius;
        objects_.push_back({static_cast<std::uint32_t>(body->id()), &found->second,
                            glm::mat4(body->model_matrix(fraction)), static_cast<float>(1.0 / size),
                            simulation.models().model(origin.model).is_closed});
    }
    return objects_;
}

}  // namespace kerf::app
