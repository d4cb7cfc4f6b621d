#include "viewer/sim/model_preparer.h"

#include <new>

namespace kerf::sim {

ModelPreparer::ModelPreparer(std::shared_ptr<ModelLibrary> models)
    : models_(std::move(models)), thread_([this] { work(); })
{
}

ModelPreparer::~ModelPreparer()
{
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void ModelPreparer::want(const std::vector<std::size_t>& models, const std::string& backend, ProxyKind proxy)
{
    std::vector<Wish> wishes;
    for (const std::size_t model : models)
        if (!models_->is_stocked(model, backend, proxy)) wishes.push_back({model, backend, proxy});
    const std::lock_guard lock(mutex_);
    std::swap(wishes_, wishes);
    if (!wishes_.empty()) changed_.notify_all();
}

void ModelPreparer::finish()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return wishes_.empty() && !is_working_; });
}

void ModelPreparer::work()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return is_ending_ || !wishes_.empty(); });
        if (is_ending_) return;
        const Wish wish = wishes_.front();
        wishes_.erase(wishes_.begin());
        is_working_ = true;
        lock.unlock();
        try {
            models_->stock(wish.model, wish.backend, wish.proxy);
        } catch (const std::bad_alloc&) {
            // Whoever throws the model finds out, and says so.
        }
        lock.lock();
        is_working_ = false;
        changed_.notify_all();
    }
}

}  // namespace kerf::sim
