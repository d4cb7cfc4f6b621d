#include "viewer/sim/model_library.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <system_error>
#include <utility>

#include "back_ends/back_ends.h"
#include "common/io/mesh_file.h"
#include "common/proxy/collision_proxy.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/body_proxies.h"

namespace kerf::sim {

namespace {

/// Files name images beside themselves; those of other systems with the slash that they use.
std::filesystem::path file_of_texture(const std::filesystem::path& folder, std::string name)
{
    std::error_code ignored;
    if (!std::filesystem::exists(folder / name, ignored)) std::replace(name.begin(), name.end(), '\\', '/');
    return folder / name;
}

}  // namespace

std::span<const std::string_view> report_model_names()
{
    static constexpr std::array<std::string_view, 15> kNames{"car",       "cube",   "rook",     "pedestal", "horse",
                                                             "icosphere", "bishop", "cylinder", "pawn",     "cone",
                                                             "barrel",    "king",   "sphere",   "queen",    "monkey"};
    return kNames;
}

std::size_t ModelLibrary::add(Model model)
{
    model.box = model.mesh->bounds();
    const std::lock_guard lock(mutex_);
    models_.push_back(std::make_unique<Model>(std::move(model)));
    return models_.size() - 1;
}

std::size_t ModelLibrary::add(std::string name, ProvenMesh mesh, bool is_closed)
{
    Model model;
    model.name = std::move(name);
    model.mesh = std::move(mesh);
    model.is_closed = is_closed;
    return add(std::move(model));
}

std::size_t ModelLibrary::add_file(const std::filesystem::path& path)
{
    Model model;
    model.name = path.stem().string();
    io::LoadedMesh loaded = io::read_mesh(path);
    model.is_closed = loaded.is_closed();
    model.mesh = std::move(loaded.mesh);
    model.coarse_coordinates = loaded.facts.has_coarse_coordinates();
    const Box box = model.mesh->bounds();
    const double radius = 0.5 * glm::distance(glm::dvec3(box.lo), glm::dvec3(box.hi));
    if (!(radius <= kLargestMesh && radius >= 1.0 / kLargestMesh))
        throw io::FileError(path.string() +
                            ": the mesh is too large or too small to be thrown, beyond 1e18 mesh units");
    model.folder = path.parent_path();
    model.files = std::move(loaded.files);
    for (Material& material : model.mesh.materials()) {
        if (material.texture.empty()) continue;
        model.files.push_back(file_of_texture(model.folder, material.texture));
        material.texture = model.files.back().string();
    }
    return add(std::move(model));
}

void ModelLibrary::add_report_models(const std::filesystem::path& folder)
{
    for (const std::string_view name : report_model_names()) add_file(folder / (std::string(name) + ".obj"));
}

void ModelLibrary::empty_model(std::size_t index)
{
    // What is freed goes after the lock: it takes time.
    ProvenMesh mesh;
    std::vector<std::shared_ptr<Prepared>> prepared;
    const std::lock_guard lock(mutex_);
    std::swap(mesh, models_[index]->mesh);
    const auto first = prepared_.lower_bound({index, std::string()}), last = prepared_.lower_bound({index + 1, {}});
    for (auto entry = first; entry != last; ++entry) prepared.push_back(std::move(entry->second));
    prepared_.erase(first, last);
}

std::size_t ModelLibrary::size() const
{
    const std::lock_guard lock(mutex_);
    return models_.size();
}

const Model& ModelLibrary::model(std::size_t index) const
{
    const std::lock_guard lock(mutex_);
    return *models_[index];
}

std::shared_ptr<ModelLibrary::Prepared> ModelLibrary::entry(std::size_t index, const std::string& backend)
{
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Prepared>& place = prepared_[{index, backend}];
    if (!place) place = std::make_shared<Prepared>();
    return place;
}

std::shared_ptr<ModelLibrary::Prepared> ModelLibrary::find_entry(std::size_t index, const std::string& backend) const
{
    const std::lock_guard lock(mutex_);
    const auto found = prepared_.find({index, backend});
    return found == prepared_.end() ? nullptr : found->second;
}

void ModelLibrary::prepare_once(Prepared& entry, std::size_t index, const std::string& backend)
{
    if (entry.ready) return;
    if (const std::unique_ptr<Backend> maker = make_back_end(backend)) {
        PrepareResult result = maker->prepare(model(index).mesh);
        entry.object = std::move(result.object);
        if (!entry.object) entry.error = model(index).name + " can't be prepared: " + result.reason;
    } else {
        entry.error = "there is no back end '" + backend + "'";
    }
    entry.ready = true;
}

std::string ModelLibrary::prepare(std::size_t index, const std::string& backend)
{
    const std::shared_ptr<Prepared> wanted = entry(index, backend);
    const std::lock_guard lock(wanted->mutex);
    prepare_once(*wanted, index, backend);
    return wanted->error;
}

bool ModelLibrary::is_prepared(std::size_t index, const std::string& backend) const
{
    const std::shared_ptr<Prepared> found = find_entry(index, backend);
    return found && found->ready;
}

void ModelLibrary::measure_once(Prepared& entry, ProxyKind proxy)
{
    if (!entry.object) return;
    if (!entry.mass) entry.mass = entry.object->mass_properties();
    std::shared_ptr<const CollisionProxy>& known = entry.proxies[proxy];
    if (!known) known = std::make_shared<const CollisionProxy>(body_proxy(*entry.object, proxy));
}

void ModelLibrary::stock(std::size_t index, const std::string& backend, ProxyKind proxy)
{
    const std::shared_ptr<Prepared> wanted = entry(index, backend);
    const std::lock_guard lock(wanted->mutex);
    prepare_once(*wanted, index, backend);
    measure_once(*wanted, proxy);
    if (!wanted->object || wanted->spare) return;
    wanted->spare = wanted->object->clone();
    wanted->spare_copy = ++copies_;
}

bool ModelLibrary::is_stocked(std::size_t index, const std::string& backend, ProxyKind proxy) const
{
    const std::shared_ptr<Prepared> found = find_entry(index, backend);
    if (!found) return false;
    const std::unique_lock lock(found->mutex, std::try_to_lock);
    if (!lock || !found->ready) return false;
    return !found->object || (found->spare && found->proxies.contains(proxy));
}

std::optional<StockedCopy> ModelLibrary::stocked(std::size_t index, const std::string& backend) const
{
    const std::shared_ptr<Prepared> found = find_entry(index, backend);
    if (!found) return std::nullopt;
    const std::unique_lock lock(found->mutex, std::try_to_lock);
    if (!lock || !found->spare) return std::nullopt;
    return StockedCopy{found->spare.get(), found->spare_copy};
}

Throwable ModelLibrary::take(std::size_t index, const std::string& backend, ProxyKind proxy)
{
    const std::shared_ptr<Prepared> wanted = entry(index, backend);
    const std::lock_guard lock(wanted->mutex);
    if (!wanted->ready) ++late_preparations_;
    prepare_once(*wanted, index, backend);
    measure_once(*wanted, proxy);
    Throwable taken;
    if (!wanted->object) return taken;
    if (wanted->spare) {
        taken.object = std::move(wanted->spare);
        taken.copy = wanted->spare_copy;
    } else {
        ++late_copies_;
        taken.object = wanted->object->clone();
        taken.copy = ++copies_;
    }
    taken.mass = *wanted->mass;
    taken.bounds = wanted->object->bounds();
    taken.proxy = wanted->proxies.at(proxy);
    return taken;
}

std::unique_ptr<Cuttable> ModelLibrary::make(std::size_t index, const std::string& backend)
{
    const std::shared_ptr<Prepared> wanted = entry(index, backend);
    const std::lock_guard lock(wanted->mutex);
    prepare_once(*wanted, index, backend);
    if (wanted->spare) return std::move(wanted->spare);
    return wanted->object ? wanted->object->clone() : nullptr;
}

}  // namespace kerf::sim
