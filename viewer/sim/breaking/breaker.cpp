#include "viewer/sim/breaking/breaker.h"

#include <new>
#include <utility>

#include "common/support/stopwatch.h"

namespace kerf::sim {
namespace {

/// Keys of pieces: no library makes so many copies.
constexpr std::uint64_t kFirstKey = std::uint64_t(1) << 63;

/// Mass, box and proxy of each piece: what a body needs.
void weigh(Fracture& fracture, BreakJob& job)
{
    for (std::size_t i = 0; Object* const piece = fracture.piece(i); ++i) {
        BrokenPiece ready;
        ready.box = piece->bounds();
        ready.solid = solid_of(piece->mass_properties(), ready.box, job.scale);
        ready.proxy = body_proxy(*piece, job.proxy);
        ready.object = std::move(*piece);
        job.pieces.push_back(std::move(ready));
    }
    job.bonds.assign(fracture.bonds().begin(), fracture.bonds().end());
}

}  // namespace

Breaker::~Breaker()
{
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Breaker::start(std::shared_ptr<BreakJob> job)
{
    {
        const std::lock_guard lock(mutex_);
        jobs_.push_back(std::move(job));
    }
    changed_.notify_all();
    if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
}

void Breaker::work()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return is_ending_ || !jobs_.empty(); });
        if (is_ending_) return;
        const std::shared_ptr<BreakJob> job = std::move(jobs_.front());
        jobs_.pop_front();
        lock.unlock();
        carry_out(*job);
        job->is_done = true;
        job->is_done.notify_all();
        lock.lock();
    }
}

void Breaker::carry_out(BreakJob& job)
{
    const auto goes_on = [](void* ending, double) { return !*static_cast<const std::atomic<bool>*>(ending); };
    try {
        core::Stopwatch watch;
        if (job.ray) {
            const std::optional<glm::dvec3> hit = first_hit(job.object, *job.ray);
            if (!hit) {
                job.status = Status::missed;
                return;
            }
            job.options.at = Point(hit->x, hit->y, hit->z);
        }
        if (job.options.at) job.at = glm::dvec3(*job.options.at);
        job.options.progress = goes_on;
        job.options.user = &is_ending_;
        Fracture fracture = kerf::fracture(job.object, job.options);
        job.fracture_ms = watch.lap();
        job.status = fracture.status();
        job.reason = fracture.reason();
        if (!ok(job.status)) return;
        weigh(fracture, job);
        for (BrokenPiece& piece : job.pieces) piece.key = kFirstKey + pieces_++;
        job.object = {};
        job.proxy_ms = watch.lap();
    } catch (const std::bad_alloc&) {
        job.pieces.clear();
        job.status = Status::out_of_memory;
        job.reason = "there is not enough memory for the pieces";
    }
}

}  // namespace kerf::sim
