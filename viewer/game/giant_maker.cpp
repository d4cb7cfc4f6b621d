#include "viewer/game/giant_maker.h"

#include <kerf/shapes.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <list>
#include <mutex>
#include <new>

#include "viewer/sim/back_ends.h"

namespace kerf::game {
namespace {

using Clock = std::chrono::steady_clock;

/// A stage that is at work: the share of the whole time at its start and at its end, and how long it takes. Measured
/// with a million triangles and the half-edge back end; others are faster, and the last stage ends early.
struct StageTime
{
    double from, to;
    double us_per_triangle;
};
constexpr StageTime kShaping{0.0, 0.12, 0.32}, kJoining{0.12, 0.30, 0.45}, kPreparing{0.30, 1.0, 1.85};

const StageTime& time_of(GiantStage stage)
{
    return stage == GiantStage::shaping ? kShaping : stage == GiantStage::joining ? kJoining : kPreparing;
}

constexpr Material kRock{"rock", {0.23f, 0.20f, 0.18f, 1.0f}};

/// Threads that nobody waits for any more. They end by themselves; the program's end waits for them.
class Retired
{
public:
    ~Retired()
    {
        for (Entry& entry : threads_) entry.thread.join();
    }
    void add(std::thread thread, std::shared_ptr<std::atomic<bool>> has_ended)
    {
        const std::lock_guard lock(mutex_);
        threads_.remove_if([](Entry& entry) {
            if (!*entry.has_ended) return false;
            entry.thread.join();
            return true;
        });
        threads_.push_back({std::move(has_ended), std::move(thread)});
    }

private:
    struct Entry
    {
        std::shared_ptr<std::atomic<bool>> has_ended;
        std::thread thread;
    };
    std::mutex mutex_;
    std::list<Entry> threads_;
};

Retired& retired()
{
    // Threads use this list of names: it must go after they did.
    static_cast<void>(sim::backend_names());
    static Retired threads;
    return threads;
}

}  // namespace

std::string_view name_of(GiantStage stage)
{
    switch (stage) {
        case GiantStage::idle:
            return "idle";
        case GiantStage::shaping:
            return "shaping";
        case GiantStage::joining:
            return "joining";
        case GiantStage::preparing:
            return "preparing";
        case GiantStage::ready:
            return "ready";
        case GiantStage::failed:
            return "failed";
    }
    return "idle";
}

struct GiantMaker::Task
{
    std::shared_ptr<sim::ModelLibrary> models;
    std::int64_t triangles = 0;
    std::uint64_t seed = 0;
    std::string backend;
    sim::ProxyKind proxy = sim::ProxyKind::bounded_hull;
    std::optional<std::size_t> old_model;  ///< of an earlier size: to be emptied
    std::optional<std::size_t> model;      ///< known from the start when only a copy is wanted
    std::string error;
    std::atomic<GiantStage> stage = GiantStage::shaping;  ///< `model` and `error` are set before `ready` and `failed`
    /// Set by who is first: the task, which has done its work, or its owner, who has lost interest.
    std::atomic<bool> is_settled = false;
    std::shared_ptr<std::atomic<bool>> has_ended = std::make_shared<std::atomic<bool>>(false);

    std::atomic<Clock::rep> stage_start = Clock::now().time_since_epoch().count();

    double shown = 0.0;  ///< progress, for its owner only

    void move_to(GiantStage next)
    {
        stage_start = Clock::now().time_since_epoch().count();
        stage = next;
        stage.notify_all();
    }

    void run()
    {
        try {
            if (old_model) models->empty_model(*old_model);
            if (!model) make_mesh();
            if (model && error.empty()) prepare();
        } catch (const std::bad_alloc&) {
            error = "there is not enough memory for " + std::to_string(triangles) + " triangles";
        }
        if (is_settled.exchange(true)) {
            if (model) models->empty_model(*model);
        } else {
            move_to(error.empty() ? GiantStage::ready : GiantStage::failed);
        }
        *has_ended = true;
    }

    /// Leaves out what nobody waits for any more.
    void make_mesh()
    {
        if (is_settled) return;
        ShapeOptions options;
        options.seed = seed;
        options.material = &kRock;
        options.progress = [](void* task, double share) { return static_cast<Task*>(task)->go_on(share); };
        options.user = this;
        Result<Mesh> mesh = make_shape("asteroid", std::uint64_t(triangles), options);
        if (mesh.status() == Status::cancelled) return;
        if (mesh.status() == Status::out_of_memory) throw std::bad_alloc();
        error = mesh.reason();
        if (mesh) model = models->add("asteroid", *std::move(mesh), true);
    }

    /// While the mesh is made. False if nobody waits for it any more.
    bool go_on(double share)
    {
        if (share > 0.0 && stage == GiantStage::shaping) move_to(GiantStage::joining);
        return !is_settled;
    }

    void prepare()
    {
        move_to(GiantStage::preparing);
        if (is_settled) return;
        error = models->prepare(*model, backend);
        if (error.empty() && !is_settled) models->stock(*model, backend, proxy);
    }
};

GiantMaker::~GiantMaker()
{
    if (const std::optional<std::size_t> model = give_up()) models_->empty_model(*model);
}

std::optional<std::size_t> GiantMaker::give_up()
{
    if (!task_) return std::nullopt;
    const bool was_done = task_->is_settled.exchange(true);
    retired().add(std::move(thread_), task_->has_ended);
    return was_done ? task_->model : std::nullopt;
}

void GiantMaker::request(std::int64_t triangles, std::uint64_t seed, const std::string& backend, sim::ProxyKind proxy)
{
    auto task = std::make_shared<Task>();
    task->models = models_;
    task->triangles = triangles;
    task->seed = seed;
    task->backend = backend;
    task->proxy = proxy;
    if (const std::optional<std::size_t> made = give_up()) {
        const bool is_same = task_->triangles == triangles && task_->seed == seed;
        (is_same ? task->model : task->old_model) = made;
        if (is_same) task->stage = GiantStage::preparing;
    }
    task_ = std::move(task);
    thread_ = std::thread([task = task_] { task->run(); });
}

GiantStage GiantMaker::stage() const
{
    return task_ ? task_->stage.load() : GiantStage::idle;
}

double GiantMaker::progress() const
{
    const GiantStage now = stage();
    if (now == GiantStage::idle) return 0.0;
    if (is_done()) return 1.0;
    const Clock::duration elapsed(Clock::now().time_since_epoch().count() - task_->stage_start);
    const StageTime& stage_time = time_of(now);
    const double expected = 1e-6 * stage_time.us_per_triangle * double(task_->triangles);
    // Never at the end before the end: a slow machine is shown as slow.
    const double done = 1.0 - std::exp(-std::chrono::duration<double>(elapsed).count() / expected);
    const double progress = stage_time.from + (stage_time.to - stage_time.from) * std::clamp(done, 0.0, 1.0);
    // The stage may have changed between the two looks at it.
    return task_->shown = std::max(task_->shown, progress);
}

void GiantMaker::wait()
{
    if (!task_) return;
    for (GiantStage stage = task_->stage; stage != GiantStage::ready && stage != GiantStage::failed;
         stage = task_->stage)
        task_->stage.wait(stage);
}

std::size_t GiantMaker::model() const
{
    return task_->model.value();
}

std::string GiantMaker::error() const
{
    return task_->error;
}

}  // namespace kerf::game
