#include <kerf/object.h>

#include <memory>
#include <thread>

#include "api/back_end_choice.h"
#include "api/convert.h"
#include "api/mesh_data.h"
#include "api/no_memory.h"
#include "back_ends/back_ends.h"

namespace kerf {

namespace {

constexpr const char* kNoMemoryForObject = "there is not enough memory for the object; free some";
constexpr const char* kEmpty = "the object is empty: it was cut, moved from, or never made";

const char* name_of(const PrepareOptions& options, const Mesh& mesh)
{
    if (options.back_end_name != nullptr) return options.back_end_name;
    switch (options.back_end) {
        case BackEnd::linear:
            return "linear";
        case BackEnd::halfedge:
            return "halfedge";
        case BackEnd::automatic:
            break;
    }
    return core::find_back_end("halfedge") != nullptr && preparing_pays(mesh.data()->mesh(), options.cuts_expected)
               ? "halfedge"
               : "linear";
}

Result<Object> cancelled_object()
{
    return {Status::cancelled, Sentence("the caller asked to stop; there is no object")};
}

}  // namespace

Object::Object(Object&& other) noexcept : inside_(std::exchange(other.inside_, nullptr)) {}

Object& Object::operator=(Object&& other) noexcept
{
    Object taken(std::move(other));
    std::swap(inside_, taken.inside_);
    return *this;
}

Object::~Object()
{
    delete inside_;
}

Result<Object> prepare(Mesh mesh, const PrepareOptions& options) noexcept
{
    if (mesh.is_empty()) return {Status::invalid_mesh, Sentence("the mesh is empty; make one with Mesh::make()")};
    return result_of<Object>(kNoMemoryForObject, [&]() -> Result<Object> {
        const core::RegisteredBackend* const entry = core::find_back_end(name_of(options, mesh));
        if (entry == nullptr)
            return {Status::invalid_argument,
                    Sentence("this build has no such back end; back_end() lists those it has")};
        core::PrepareOptions inside;
        inside.listener = {options.listener.released, options.listener.user};
        inside.progress = {options.progress, options.user};
        inside.threads = options.threads != 0 ? options.threads : std::thread::hardware_concurrency();
        inside.cuts_with_room = options.cuts_with_room;
        // Both ends of a bar, whatever the back end says between.
        const auto goes_on = [&](double share) {
            return options.progress == nullptr || options.progress(options.user, share);
        };
        if (!goes_on(0.0)) return cancelled_object();
        const bool is_closed = mesh.is_closed();
        core::PrepareResult prepared = mesh.data()->prepare(*entry->back_end, inside, mesh.data()->has_one_owner());
        if (prepared.object == nullptr) return {to_public(prepared.status), Sentence(prepared.reason.c_str())};
        prepared.object->memory = {entry->name.c_str(), is_closed};
        if (!goes_on(1.0)) return cancelled_object();
        return Object(prepared.object.release());
    });
}

Result<Object> Object::clone() const noexcept
{
    if (is_empty()) return {Status::invalid_argument, Sentence(kEmpty)};
    return result_of<Object>(kNoMemoryForObject, [&]() -> Result<Object> {
        std::unique_ptr<core::Cuttable> copy = inside_->clone();
        copy->memory = inside_->memory;
        return Object(copy.release());
    });
}

std::uint64_t Object::triangle_count() const noexcept
{
    return is_empty() ? 0 : inside_->triangle_count();
}

Box Object::bounds() const noexcept
{
    return to_public(is_empty() ? core::Box() : inside_->bounds());
}

MassProperties Object::mass_properties() const noexcept
{
    if (is_empty()) return {};
    return answer_or(MassProperties(), [&] {
        MassProperties result = to_public(inside_->mass_properties());
        result.is_of_solid = inside_->memory.is_of_solid;
        return result;
    });
}

Result<Mesh> Object::mesh() const noexcept
{
    if (is_empty()) return {Status::invalid_argument, Sentence(kEmpty)};
    return result_of<Mesh>(kNoMemoryForObject, [&]() -> Result<Mesh> {
        return Mesh(std::make_unique<Mesh::Data>(inside_->to_indexed_mesh()).release());
    });
}

std::size_t Object::loop_count() const noexcept
{
    return is_empty() ? 0 : inside_->section_loops().size();
}

SectionLoop Object::loop(std::size_t i) const noexcept
{
    if (i >= loop_count()) return {};
    const core::SectionLoop& loop = inside_->section_loops()[i];
    return {{reinterpret_cast<const Vec3f*>(loop.points.data()), loop.points.size()}, loop.closed};
}

bool Object::shares_buffers_with(const Object& other) const noexcept
{
    return !is_empty() && !other.is_empty() && inside_->shares_buffers_with(*other.inside_);
}

Status Object::detach() noexcept
{
    return is_empty() ? Status::invalid_argument : to_public(inside_->detach());
}

Status Object::compact() noexcept
{
    if (is_empty()) return Status::invalid_argument;
    return answer_or(Status::out_of_memory, [&] {
        inside_->compact();
        return Status::done;
    });
}

bool Object::is_scattered() const noexcept
{
    return !is_empty() && answer_or(false, [&] { return inside_->wants_compaction(); });
}

std::uint32_t Object::add_material(const Material& material) noexcept
{
    if (is_empty()) return kNone;
    return answer_or(kNone, [&] { return inside_->add_material(to_core(material)); });
}

std::size_t Object::material_count() const noexcept
{
    return is_empty() ? 0 : inside_->materials().size();
}

Material Object::material(std::size_t i) const noexcept
{
    return i < material_count() ? to_public(inside_->materials()[i]) : Material();
}

const char* Object::back_end_name() const noexcept
{
    return is_empty() ? "" : inside_->memory.back_end;
}

}  // namespace kerf
