#include "viewer/sim/model_shelf.h"

#include <array>

#include "common/io/mesh_file.h"
#include "viewer/sim/back_ends.h"

namespace kerf::sim {

std::span<const std::string_view> report_model_names()
{
    static constexpr std::array<std::string_view, 15> kNames{"car",       "cube",   "rook",     "pedestal", "horse",
                                                             "icosphere", "bishop", "cylinder", "pawn",     "cone",
                                                             "barrel",    "king",   "sphere",   "queen",    "monkey"};
    return kNames;
}

std::size_t ModelShelf::add(Model model)
{
    model.box = model.mesh.bounds();
    models_.push_back(std::make_unique<Model>(std::move(model)));
    return models_.size() - 1;
}

std::size_t ModelShelf::add(std::string name, IndexedMesh mesh)
{
    Model model;
    model.name = std::move(name);
    model.mesh = std::move(mesh);
    return add(std::move(model));
}

std::size_t ModelShelf::add_file(const std::filesystem::path& path)
{
    Model model;
    model.name = path.stem().string();
    model.mesh = io::read_mesh(path).mesh;
    model.folder = path.parent_path();
    return add(std::move(model));
}

void ModelShelf::add_report_models(const std::filesystem::path& folder)
{
    for (const std::string_view name : report_model_names()) add_file(folder / (std::string(name) + ".obj"));
}

const ModelShelf::Prepared& ModelShelf::prepared(std::size_t index, const std::string& backend)
{
    // Another thread that wants the same waits for it; one that wants something else waits as well, which is why big
    // meshes are prepared before they are needed.
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Prepared>& place = prepared_[{index, backend}];
    if (!place) {
        auto fresh = std::make_unique<Prepared>();
        if (const std::unique_ptr<Backend> maker = make_backend(backend)) {
            PrepareResult result = maker->prepare(models_[index]->mesh);
            fresh->object = std::move(result.object);
            fresh->error = fresh->object ? "" : models_[index]->name + " can't be prepared: " + result.reason;
        } else {
            fresh->error = "there is no back end '" + backend + "'";
        }
        place = std::move(fresh);
    }
    return *place;
}

std::string ModelShelf::prepare(std::size_t index, const std::string& backend)
{
    return prepared(index, backend).error;
}

bool ModelShelf::is_prepared(std::size_t index, const std::string& backend) const
{
    const std::lock_guard lock(mutex_);
    return prepared_.contains({index, backend});
}

std::unique_ptr<Cuttable> ModelShelf::make(std::size_t index, const std::string& backend)
{
    const Prepared& ready = prepared(index, backend);
    return ready.object ? ready.object->clone() : nullptr;
}

}  // namespace kerf::sim
