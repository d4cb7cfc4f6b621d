#pragma once

#include <kerf/c.h>
#include <kerf/kerf.h>

#include <cstddef>
#include <vector>

// What stands behind the handles of kerf/c.h.

namespace kerf::c_api {

/// What kerf_free() ends, of whatever kind.
struct Handle
{
    Handle() = default;
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    virtual ~Handle() = default;
};

}  // namespace kerf::c_api

// A void* may be made a Handle* again only if that is where each kind begins: single bases, and no member before.

struct kerf_mesh : kerf::c_api::Handle
{
    explicit kerf_mesh(kerf::Mesh mesh_) noexcept : mesh(std::move(mesh_)) {}
    kerf::Mesh mesh;
};

struct kerf_object : kerf::c_api::Handle
{
    explicit kerf_object(kerf::Object object_) noexcept : object(std::move(object_)) {}
    kerf::Object object;
};

struct kerf_pieces : kerf::c_api::Handle
{
    kerf::Cut cut;
};

struct kerf_section : kerf::c_api::Handle
{
    kerf::Section section;
    std::vector<std::size_t> path_starts;
    std::vector<std::uint32_t> parents, sources;
    std::vector<double> areas;
    std::vector<std::uint8_t> is_closed;
};

struct kerf_draw : kerf::c_api::Handle
{
    kerf::DrawView view;
    std::vector<std::uint32_t> ranges;
};

struct kerf_fracture : kerf::c_api::Handle
{
    kerf::Fracture fracture;
    std::vector<std::size_t> cell_starts;
    std::vector<std::uint32_t> cells, bonds;
    std::vector<double> areas, centres, normals;
};
