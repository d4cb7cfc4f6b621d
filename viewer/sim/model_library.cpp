#include "viewer/sim/model_library.h"

#include <kerf/io.h>

#include <algorithm>
#include <array>
#include <new>
#include <system_error>
#include <utility>

#include "common/files/file_error.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/body_proxies.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/sim/rehearsal.h"

namespace kerf::sim {

namespace {

/// Files name images beside themselves; those of other systems with the slash that they use.
std::filesystem::path file_of_texture(const std::filesystem::path& folder, std::string name)
{
    std::error_code ignored;
    if (!std::filesystem::exists(folder / name, ignored)) std::replace(name.begin(), name.end(), '\\', '/');
    return folder / name;
}

/// For each material the file of its image, or nothing.
std::vector<std::string> images_of(const Mesh& mesh, const std::filesystem::path& folder)
{
    std::vector<std::string> images;
    for (std::size_t i = 0; i < mesh.material_count(); ++i) {
        const std::string name = mesh.material(i).base_colour_image;
        images.push_back(name.empty() ? name : file_of_texture(folder, name).string());
    }
    return images;
}

/// @throws std::bad_alloc
Object copy_of(const Object& object)
{
    Result<Object> copy = object.clone();
    if (!copy) throw std::bad_alloc();
    return *std::move(copy);
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
    model.box = model.mesh.bounds();
    const std::lock_guard lock(mutex_);
    models_.push_back(std::make_unique<Model>(std::move(model)));
    return models_.size() - 1;
}

std::size_t ModelLibrary::add(std::string name, Mesh mesh, bool is_closed)
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
    FileReport report;
    Result<Mesh> mesh = read_mesh(path.c_str(), &report);
    if (!mesh) throw core::io::FileError(mesh.reason());
    model.is_closed = report.mesh().facts.is_closed();
    model.mesh = *std::move(mesh);
    model.coarse_coordinates = report.mesh().facts.has_coarse_coordinates;
    const double radius = radius_of(model.mesh.bounds());
    if (!(radius <= kLargestMesh && radius >= 1.0 / kLargestMesh))
        throw core::io::FileError(path.string() +
                                  ": the mesh is too large or too small to be thrown, beyond 1e18 mesh units");
    for (std::size_t i = 0; i < report.file_count(); ++i) model.files.emplace_back(report.file(i));
    model.images = images_of(model.mesh, path.parent_path());
    for (const std::string& image : model.images)
        if (!image.empty()) model.files.emplace_back(image);
    return add(std::move(model));
}

void ModelLibrary::add_report_models(const std::filesystem::path& folder)
{
    for (const std::string_view name : report_model_names()) add_file(folder / (std::string(name) + ".obj"));
}

void ModelLibrary::empty_model(std::size_t index)
{
    // What is freed goes after the lock: it takes time.
    Mesh mesh;
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
    if (known_back_end(backend).empty()) {
        entry.error = "there is no back end '" + backend + "'";
    } else {
        Result<Object> object = sim::prepare(model(index).mesh, backend);
        if (object) rehearse(backend);
        if (!object) entry.error = model(index).name + " can't be prepared: " + object.reason();
        entry.object = *std::move(object);
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
    if (!entry.mass) entry.mass = entry.object.mass_properties();
    std::shared_ptr<const CollisionProxy>& known = entry.proxies[proxy];
    if (!known) known = std::make_shared<const CollisionProxy>(body_proxy(entry.object, proxy));
}

void ModelLibrary::stock(std::size_t index, const std::string& backend, ProxyKind proxy)
{
    const std::shared_ptr<Prepared> wanted = entry(index, backend);
    const std::lock_guard lock(wanted->mutex);
    prepare_once(*wanted, index, backend);
    measure_once(*wanted, proxy);
    if (!wanted->object || wanted->spare) return;
    wanted->spare = copy_of(wanted->object);
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
    return StockedCopy{&found->spare, found->spare_copy};
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
        taken.object = copy_of(wanted->object);
        taken.copy = ++copies_;
    }
    taken.mass = *wanted->mass;
    taken.bounds = wanted->object.bounds();
    taken.proxy = wanted->proxies.at(proxy);
    return taken;
}

Object ModelLibrary::make(std::size_t index, const std::string& backend)
{
    const std::shared_ptr<Prepared> wanted = entry(index, backend);
    const std::lock_guard lock(wanted->mutex);
    prepare_once(*wanted, index, backend);
    if (wanted->spare) return std::move(wanted->spare);
    return wanted->object ? copy_of(wanted->object) : Object();
}

}  // namespace kerf::sim
