#include "common/cutting/cut.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <new>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>

#include "common/mesh/coordinate_grain.h"

namespace kerf {

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
    }
    return "unknown";
}

std::string_view outcome_name(Status status)
{
    return status == Status::done ? "cut" : name_of(status);
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

namespace {

/// "cap" is 0, "cap.7" is 7. Others have none: no number is spelt in two ways.
std::optional<std::uint32_t> cap_number(std::string_view name)
{
    constexpr std::string_view kCap = "cap";
    if (name.substr(0, kCap.size()) != kCap) return std::nullopt;
    if (name == kCap) return 0;
    const std::string_view digits = name.substr(kCap.size() + 1);
    if (name[kCap.size()] != '.' || digits.empty() || digits.front() == '0') return std::nullopt;
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return number;
}

/// A number that no name has: there are more numbers than names, so some part of the numbers has fewer names than
/// numbers, and a part of that again. Four passes, without memory: back ends call this when nothing may fail any more.
std::uint32_t free_cap_number(const std::vector<Material>& materials)
{
    std::uint64_t first = 0;
    for (int bits = 24; bits >= 0; bits -= 8) {
        std::array<std::uint64_t, 256> names{};
        for (const Material& material : materials)
            if (const auto number = cap_number(material.name); number && *number >= first)
                if (const std::uint64_t part = (*number - first) >> bits; part < names.size()) ++names[part];
        const std::uint64_t numbers = std::uint64_t(1) << bits;
        const auto part = std::find_if(names.begin(), names.end(), [&](std::uint64_t n) { return n < numbers; });
        first += static_cast<std::uint64_t>(part - names.begin()) << bits;
    }
    return static_cast<std::uint32_t>(first);
}

}  // namespace

std::uint32_t add_cap_material(std::vector<Material>& materials)
{
    const std::uint32_t number = free_cap_number(materials);
    std::string name = number == 0 ? "cap" : "cap." + std::to_string(number);  // as short as needs no memory
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

std::uint64_t new_buffers_serial() noexcept
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
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
    } else if (!plane.valid()) {
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
    const bool spent = result.status == Status::done || result.status == Status::open_section;
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
        return {Status::done, make(std::move(mesh)), {}, is_coarse};
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
