#include "common/cutting/cut.h"

#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>

#include "common/caps/constrained_triangulator.h"
#include "common/cutting/breakable.h"
#include "common/mesh/coordinate_grain.h"

namespace kerf::core {

namespace {

bool is_finite(const glm::dvec3& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

std::string_view name_of(Status status)
{
    switch (status) {
        case Status::done:
            return "done";
        case Status::missed:
            return "missed";
        case Status::open_section:
            return "open_section";
        case Status::invalid_argument:
            return "invalid_argument";
        case Status::invalid_mesh:
            return "invalid_mesh";
        case Status::out_of_memory:
            return "out_of_memory";
        case Status::cancelled:
            return "cancelled";
        case Status::not_separated:
            return "not_separated";
    }
    return "unknown";
}

bool can_close(CapQuality quality) noexcept
{
    return quality == CapQuality::fast || has_constrained_ways();
}

std::unique_ptr<Breakable> Cuttable::breakable() const
{
    return nullptr;
}

Status Cuttable::detach() noexcept
{
    try {
        if (has_relatives()) compact();
        return Status::done;
    } catch (const std::bad_alloc&) {
        return Status::out_of_memory;
    } catch (const std::length_error&) {
        // A container asked for more elements than its type can count.
        return Status::out_of_memory;
    }
}

CutResult cut(std::unique_ptr<Cuttable> object, const Plane& plane, const CutOptions& options)
{
    CutResult result;
    if (!object) {
        result.status = Status::invalid_mesh;
    } else if (!plane.valid() || !std::isfinite(options.cap_uv_scale) || !can_close(options.cap_quality) ||
               (options.only && !is_finite(options.only->point))) {
        result.status = Status::invalid_argument;
    } else {
        try {
            result = object->cut_by(plane, options);
        } catch (const std::bad_alloc&) {
            result = {};
            result.status = Status::out_of_memory;
        } catch (const std::length_error&) {
            // A container asked for more elements than its type can count.
            result = {};
            result.status = Status::out_of_memory;
        }
    }
    if (object != nullptr) {
        Cuttable::Memory memory = object->memory;
        memory.is_of_solid = memory.is_of_solid && options.build_caps && result.status != Status::open_section;
        for (auto* side : {&result.positive, &result.negative})
            for (const std::unique_ptr<Cuttable>& piece : *side) piece->memory = memory;
    }
    const bool spent = result.status == Status::done || result.status == Status::open_section;
    if (!spent) result.object = std::move(object);
    return result;
}

namespace {

/// Calls find(section); running out of memory is a status.
template <class Find>
Status filled(PlaneSection& section, Find find) noexcept
{
    const auto fails = [&] {
        section.clear();
        return section.status = Status::out_of_memory;
    };
    section.clear();
    try {
        find(section);
    } catch (const std::bad_alloc&) {
        return fails();
    } catch (const std::length_error&) {
        // A container asked for more elements than its type can count.
        return fails();
    }
    return section.status;
}

}  // namespace

Status section(const Cuttable& object, const Plane& plane, PlaneSection& section) noexcept
{
    if (plane.valid()) return filled(section, [&](PlaneSection& found) { object.find_section(plane, found); });
    section.clear();
    return section.status = Status::invalid_argument;
}

Status section(const StackSearch& stack, std::size_t number, PlaneSection& section) noexcept
{
    return filled(section, [&](PlaneSection& found) { stack.find(number, found); });
}

namespace {

/// Says so in a sentence, where there is memory for one.
PrepareResult without_memory()
{
    PrepareResult result;
    result.status = Status::out_of_memory;
    try {
        result.reason = "there is not enough memory to prepare the mesh; divide it or free some";
    } catch (const std::bad_alloc&) {
        result.reason = "out of memory";  // as long as a string may be that needs none
    }
    return result;
}

template <class Make>
PrepareResult prepared(const ProvenMesh& mesh, Make make)
{
    try {
        if (mesh->triangles.empty())
            return {Status::invalid_mesh, nullptr, "the mesh has no triangles; give it one at least"};
        const bool is_coarse = has_coarse_coordinates(mesh.shortest_edge(), mesh.bounds());
        return {Status::done, make(), {}, is_coarse};
    } catch (const Cancelled&) {
        return {Status::cancelled, nullptr, "stopped"};
    } catch (const std::bad_alloc&) {
        return without_memory();
    } catch (const std::length_error&) {
        return without_memory();
    }
}

}  // namespace

PrepareResult Backend::prepare(ProvenMesh&& mesh, const PrepareOptions& options) const
{
    return prepared(mesh, [&] { return make(std::move(mesh), options); });
}

PrepareResult Backend::prepare(const ProvenMesh& mesh, const PrepareOptions& options) const
{
    return prepared(mesh, [&] { return make_beside(mesh, options); });
}

PrepareResult Backend::prepare(IndexedMesh mesh) const
{
    try {
        Proof proof = prove(std::move(mesh));
        if (!proof.error.empty()) return {Status::invalid_mesh, nullptr, std::move(proof.error)};
        return prepare(std::move(proof.mesh));
    } catch (const std::bad_alloc&) {
        return without_memory();
    } catch (const std::length_error&) {
        return without_memory();
    }
}

}  // namespace kerf::core
