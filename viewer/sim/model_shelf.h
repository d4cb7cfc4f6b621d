#pragma once

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
    std::filesystem::path folder;  ///< where its textures are looked for; empty: nowhere
};

/// The names of the report's fifteen models, in the order of its tables.
std::span<const std::string_view> report_model_names();

/// Models, and each prepared once for each back end that asks: throws are clones. Safe for use from several threads;
/// models are added before, and stay.
class ModelShelf
{
public:
    /// Returns the model's index.
    std::size_t add(Model model);
    std::size_t add(std::string name, IndexedMesh mesh);
    /// @throws io::FileError
    std::size_t add_file(const std::filesystem::path& path);
    /// The report's fifteen models from data/models.
    /// @throws io::FileError
    void add_report_models(const std::filesystem::path& folder);

    std::size_t size() const { return models_.size(); }
    bool empty() const { return models_.empty(); }
    const Model& model(std::size_t index) const { return *models_[index]; }

    /// Prepares a model for a back end now, unless that was done: on a worker thread to keep it off the frame.
    /// An empty string, or why it can't be.
    std::string prepare(std::size_t index, const std::string& backend);
    bool is_prepared(std::size_t index, const std::string& backend) const;

    /// A fresh copy to throw; prepares it first when nobody did. Null when preparing failed (prepare() says why).
    std::unique_ptr<Cuttable> make(std::size_t index, const std::string& backend);

private:
    struct Prepared
    {
        std::unique_ptr<Cuttable> object;
        std::string error;
    };
    const Prepared& prepared(std::size_t index, const std::string& backend);

    std::vector<std::unique_ptr<Model>> models_;
    mutable std::mutex mutex_;
    std::map<std::pair<std::size_t, std::string>, std::unique_ptr<Prepared>> prepared_;
};

}  // namespace kerf::sim
