#pragma once

#include <kerf/object.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/sim/body_proxies.h"

namespace kerf::sim {

/// A mesh that can be thrown.
struct Model
{
    std::string name;
    Mesh mesh;
    Box box;
    bool coarse_coordinates = false;  ///< Mesh::has_coarse_coordinates(): a warning
    bool is_closed = false;           ///< the surface of solids, known to have no boundary: nobody sees its back
    std::vector<std::string> images;  ///< for each material the file of its image, or nothing
    std::vector<std::filesystem::path> files;  ///< that it came from, with its images; none for generated ones
};

/// A copy to throw, and what is the same for all copies of a model: found once, because it costs the baseline a look at
/// every vertex.
struct Throwable
{
    Object object;           ///< empty: the model can't be prepared
    std::uint64_t copy = 0;  ///< which copy this is; counts up from 1 in each library
    MassProperties mass;
    Box bounds;
    std::shared_ptr<const CollisionProxy> proxy;
};

/// A copy that is ready and lies in the library until somebody takes it.
struct StockedCopy
{
    Object* object = nullptr;
    std::uint64_t copy = 0;
};

/// What take() had to do itself because nobody had done it before: a frame waited for it.
struct LateWork
{
    std::uint64_t preparations = 0;
    std::uint64_t copies = 0;
};

/// Half the diagonal of a mesh that can be thrown, mesh units, is at most this and at least the inverse of it: squares
/// of lengths must be floats for the graphics card.
inline constexpr double kLargestMesh = 1e18;

/// The names of the report's fifteen models, in the order of its tables.
std::span<const std::string_view> report_model_names();

/// Models, and each prepared once for each back end that asks: throws are clones. Safe for use from several threads:
/// preparing one model holds up nobody who wants another. Models stay, at their index.
class ModelLibrary
{
public:
    /// Returns the model's index.
    std::size_t add(Model model);
    std::size_t add(std::string name, Mesh mesh, bool is_closed = false);
    /// @throws core::io::FileError  also for a mesh that is too large or too small to be drawn (kLargestMesh)
    std::size_t add_file(const std::filesystem::path& path);
    /// The report's fifteen models from data/models.
    /// @throws core::io::FileError
    void add_report_models(const std::filesystem::path& folder);

    /// Frees a model's mesh and what was prepared of it, the stocked copy included; its name and box stay, and so do
    /// copies that were thrown. Nobody may be preparing it.
    void empty_model(std::size_t index);

    std::size_t size() const;
    bool empty() const { return size() == 0; }
    const Model& model(std::size_t index) const;

    /// Prepares a model for a back end now, unless that was done: on a worker thread to keep it off the frame.
    /// An empty string, or why it can't be. Waits for a thread that is preparing the same.
    std::string prepare(std::size_t index, const std::string& backend);
    /// Does not wait.
    bool is_prepared(std::size_t index, const std::string& backend) const;
    /// Prepares and keeps a copy ready, measured and with its proxy, so that the next take() costs nothing: for worker
    /// threads, because copying a mesh of a million triangles takes longer than a frame.
    void stock(std::size_t index, const std::string& backend, ProxyKind proxy = ProxyKind::bounded_hull);
    /// Whether stock() has nothing left to do. Does not wait: false while another thread is at it.
    bool is_stocked(std::size_t index, const std::string& backend, ProxyKind proxy = ProxyKind::bounded_hull) const;
    /// The copy that the next take() hands out; empty when there is none or another thread is at work on it. Does not
    /// wait. It stays until take() or empty_model(): for a thread that rules out both.
    std::optional<StockedCopy> stocked(std::size_t index, const std::string& backend) const;

    /// The stocked copy, or else a fresh one; prepares the model first when nobody did (prepare() says why that
    /// failed). Waits for a thread that is stocking the same.
    Throwable take(std::size_t index, const std::string& backend, ProxyKind proxy = ProxyKind::bounded_hull);
    /// The same without measures and proxy.
    Object make(std::size_t index, const std::string& backend);

    LateWork late_work() const { return {late_preparations_, late_copies_}; }

private:
    struct Prepared
    {
        std::mutex mutex;  ///< an object is cloned by one thread at a time
        std::atomic<bool> ready = false;
        Object object, spare;
        std::uint64_t spare_copy = 0;
        std::optional<MassProperties> mass;
        std::map<ProxyKind, std::shared_ptr<const CollisionProxy>> proxies;
        std::string error;
    };
    std::shared_ptr<Prepared> entry(std::size_t index, const std::string& backend);
    std::shared_ptr<Prepared> find_entry(std::size_t index, const std::string& backend) const;
    // With the entry's mutex held.
    void prepare_once(Prepared& entry, std::size_t index, const std::string& backend);
    static void measure_once(Prepared& entry, ProxyKind proxy);

    mutable std::mutex mutex_;  ///< of the containers, never held for long
    std::vector<std::unique_ptr<Model>> models_;
    /// Shared with whoever is at work on an entry while it is taken out of the library.
    std::map<std::pair<std::size_t, std::string>, std::shared_ptr<Prepared>> prepared_;
    std::atomic<std::uint64_t> copies_ = 0, late_preparations_ = 0, late_copies_ = 0;
};

}  // namespace kerf::sim
