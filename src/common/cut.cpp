#include "common/cut.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "common/coordinate_grain.h"

namespace kerf {

std::string_view name_of(Status status)
{
    switch (status) {
        case Status::cut:
            return "cut";
        case Status::missed:
            return "missed";
        case Status::open_section:
            return "open_section";
        case Status::invalid_plane:
            return "invalid_plane";
        case Status::invalid_mesh:
            return "invalid_mesh";
        case Status::out_of_memory:
            return "out_of_memory";
    }
    return "unknown";
}

std::string_view name_of(Phase phase)
{
    switch (phase) {
        case Phase::find:
            return "find";
        case Phase::walk:
            return "walk";
        case Phase::split:
            return "split";
        case Phase::copy:
            return "copy";
        case Phase::cap:
            return "cap";
        case Phase::rebuild:
            return "rebuild";
        case Phase::pivot:
            return "pivot";
        case Phase::components:
            return "components";
        case Phase::growth:
            return "growth";
    }
    return "unknown";
}

void merge_ranges(std::vector<DrawRange>& ranges)
{
    std::sort(ranges.begin(), ranges.end(), [](const DrawRange& a, const DrawRange& b) {
        return std::tie(a.kind, a.material, a.first_index) < std::tie(b.kind, b.material, b.first_index);
    });
    std::size_t last = 0;
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        DrawRange& before = ranges[last];
        const DrawRange& range = ranges[i];
        const bool follows = before.kind == range.kind && before.material == range.material &&
                             before.first_index + before.index_count == range.first_index;
        if (follows)
            before.index_count += range.index_count;
        else
            ranges[++last] = range;
    }
    if (!ranges.empty()) ranges.resize(last + 1);
}

std::uint32_t add_cap_material(std::vector<Material>& materials)
{
    const auto is_taken = [&](const std::string& name) {
        return std::any_of(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
    };
    std::string name = "cap";
    for (int number = 1; is_taken(name); ++number) name = "cap." + std::to_string(number);
    materials.push_back({std::move(name), glm::vec4(1.0f), {}});
    return static_cast<std::uint32_t>(materials.size() - 1);
}

double PhaseTimes::total() const
{
    return std::accumulate(ms.begin(), ms.end(), 0.0);
}

bool caps_exceed_section(double excess, double section_area, double section_length, double unit)
{
    return excess > std::max(kCapAgreement * std::abs(section_area), unit * section_length);
}

Status Cuttable::detach() noexcept
{
    try {
        if (has_relatives()) compact();
        return Status::cut;
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
    } else if (!plane.valid()) {
        result.status = Status::invalid_plane;
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
    const bool spent = result.status == Status::cut || result.status == Status::open_section;
    if (!spent) result.object = std::move(object);
    return result;
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

}  // namespace

PrepareResult Backend::prepare(ProvenMesh mesh) const
{
    try {
        if (mesh->triangles.empty())
            return {Status::invalid_mesh, nullptr, "the mesh has no triangles; give it one at least"};
        const bool is_coarse = has_coarse_coordinates(shortest_edge(mesh->vertices, mesh->triangles), mesh->bounds());
        return {Status::cut, make(std::move(mesh)), {}, is_coarse};
    } catch (const std::bad_alloc&) {
        return without_memory();
    } catch (const std::length_error&) {
        return without_memory();
    }
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

}  // namespace kerf
