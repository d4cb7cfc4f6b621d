#include "viewer/duel/half.h"

#include <algorithm>
#include <utility>

namespace kerf::duel {

Half::Half(std::shared_ptr<sim::ModelLibrary> models, sim::Settings settings, std::unique_ptr<sim::Scene> scene)
    : simulation_(std::move(models), std::move(settings), std::move(scene)), thread_([this] { work(); })
{
}

Half::~Half()
{
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Half::work()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return ends_ || under_way_ > 0; });
        if (ends_) return;
        const sim::Tick ticks = under_way_;
        for (sim::Tick i = 0; i < ticks && !ends_ && !failure_; ++i) {
            lock.unlock();
            std::exception_ptr failure;
            try {
                simulation_.advance();
            } catch (...) {
                failure = std::current_exception();
            }
            lock.lock();
            if (failure) failure_ = failure;
            ++done_;
        }
        under_way_ = 0;
        changed_.notify_all();
    }
}

void Half::rethrow()
{
    if (failure_) std::rethrow_exception(failure_);
}

void Half::owe(sim::Tick ticks, const std::vector<sim::InputEvent>& events)
{
    owed_ += ticks;
    input_.insert(input_.end(), events.begin(), events.end());
}

bool Half::idle()
{
    const std::lock_guard lock(mutex_);
    rethrow();
    return under_way_ == 0;
}

void Half::resume(sim::Tick most)
{
    const sim::Tick ticks = std::min(most, owed_);
    if (ticks <= 0 || !idle()) return;
    simulation_.push(input_);
    input_.clear();
    owed_ -= ticks;
    {
        const std::lock_guard lock(mutex_);
        under_way_ = ticks;
    }
    changed_.notify_all();
}

bool Half::wait_for(std::chrono::microseconds longest)
{
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest, [&] { return under_way_ == 0; });
    rethrow();
    return under_way_ == 0;
}

void Half::finish()
{
    const auto wait = [&] {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return under_way_ == 0; });
        rethrow();
    };
    wait();
    resume(owed_);
    wait();
}

sim::Tick Half::done()
{
    const std::lock_guard lock(mutex_);
    return done_;
}

sim::Tick Half::owed()
{
    const std::lock_guard lock(mutex_);
    return owed_ + under_way_;
}

}  // namespace kerf::duel
