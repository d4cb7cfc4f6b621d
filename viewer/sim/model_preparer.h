#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "viewer/sim/model_library.h"

namespace kerf::sim {

/// Keeps copies of the models that will be thrown next in the library, made by a thread of its own: a throw takes one
/// instead of preparing and copying a mesh while a frame waits. It changes when things are done and never what comes of
/// them: whoever throws before the copy is there waits for it.
class ModelPreparer
{
public:
    explicit ModelPreparer(std::shared_ptr<ModelLibrary> models);
    /// Waits for the model that is under way.
    ~ModelPreparer();
    ModelPreparer(const ModelPreparer&) = delete;
    ModelPreparer& operator=(const ModelPreparer&) = delete;

    /// From now on: these models for this back end, the first of them first. Does not wait. Cheap enough for every
    /// frame: O(models).
    void want(const std::vector<std::size_t>& models, const std::string& backend, ProxyKind proxy);
    /// Waits until everything that is wanted is there: for runs in fixed steps, so that what a frame does is the same
    /// on every machine.
    void finish();

private:
    struct Wish
    {
        std::size_t model = 0;
        std::string backend;
        ProxyKind proxy = ProxyKind::bounded_hull;
    };
    void work();

    std::shared_ptr<ModelLibrary> models_;
    std::mutex mutex_;  ///< of what follows
    std::condition_variable changed_;
    std::vector<Wish> wishes_;
    bool is_working_ = false, is_ending_ = false;
    std::thread thread_;
};

}  // namespace kerf::sim
