#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "common/cut.h"
#include "common/indexed_mesh.h"

namespace kerf::sim {

/// A mesh that can be thrown.
struct Model
{
    std::string name;
    IndexedMesh mesh;
    Box box;
    bool coarse_coordinates = false;  ///< MeshFacts::has_coarse_coordinates(): a warning
    std::filesystem::path folder;     ///< of the file that it came from; Material::texture begins with it
};

/// Half the diagonal of a mesh that can be thrown, mesh units, is at most this and at least the inverse of it: squares
/// of lengths must be floats for the graphics card.
inline constexpr double kLargestMesh = 1e18;

/// The names of the report's fifteen models, in the order of its tables.
std::span<const std::string_view> report_model_names();

/// Models, and each prepared once for each back end that asks: throws are clones. Safe for use from several threads:
/// preparing one model holds up nobody who wants another. Models stay, at their index.
class ModelShelf
{
public:
    /// Returns the model's index.
    std::size_t add(Model model);
    std::size_t add(std::string name, IndexedMesh mesh);
    /// @throws io::FileError  also for a mesh that is too large or too small to be drawn (kLargestMesh)
    std::size_t add_file(const std::filesystem::path& path);
    /// The report's fifteen models from data/models.
    /// @throws io::FileError
    void add_report_models(const std::filesystem::path& folder);

    /// Frees a model's mesh and what was prepared of it; its name and box stay, and so do copies that were thrown.
    /// Nobody may be preparing it.
    void empty_model(std::size_t index);

    std::size_t size() const;
    bool empty() const { return size() == 0; }
    const Model& model(std::size_t index) const;

    /// Prepares a model for a back end now, unless that was done: on a worker thread to keep it off the frame.
    /// An empty string, or why it can't be. Waits for a thread that is preparing the same.
    std::string prepare(std::size_t index, const std::string& backend);
    /// Does not wait.
    bool is_prepared(std::size_t index, const std::string& backend) const;
    /// Prepares and keeps a copy ready, so that the next make() costs nothing: for worker threads, because copying a
    /// mesh of a million triangles takes longer than a frame.
    void stock(std::size_t index, const std::string& backend);

    /// A fresh copy to throw; prepares it first when nobody did. Null when preparing failed (prepare() says why).
    std::unique_ptr<Cuttable> make(std::size_t index, const std::string& backend);

private:
    struct Prepared
    {
        std::mutex mutex;  ///< a Cuttable is cloned by one thread at a time
        std::atomic<bool> ready = false;
        std::unique_ptr<Cuttable> object, spare;
        std::string error;
    };
    Prepared& entry(std::size_t index, const std::string& backend);
    /// With the entry's mutex held.
    void prepare_once(Prepared& entry, std::size_t index, const std::string& backend);

    mutable std::mutex mutex_;  ///< of the containers, never held for long
    std::vector<std::unique_ptr<Model>> models_;
    std::map<std::pair<std::size_t, std::string>, std::unique_ptr<Prepared>> prepared_;
};

}  // namespace kerf::sim
