#include <kerf/c.h>
#include <kerf/section.h>

#include <memory>
#include <optional>

#include "c_api/calls.h"
#include "c_api/handles.h"

namespace kerf::c_api {
namespace {

SectionOptions to_options(const kerf_section_options& given)
{
    SectionOptions options;
    options.fill = given.fill != 0;
    if (given.up[0] != 0.0 || given.up[1] != 0.0 || given.up[2] != 0.0) options.up = to_vec3d(given.up);
    return options;
}

/// Paths as flat arrays. May throw std::bad_alloc.
void flatten(kerf_section& s)
{
    s.path_starts.assign(1, 0);
    s.parents.clear();
    s.areas.clear();
    s.is_closed.clear();
    s.sources.clear();
    for (std::size_t i = 0; i < s.section.path_count(); ++i) {
        const SectionPath path = s.section.path(i);
        s.path_starts.push_back(s.path_starts.back() + path.points.size());
        s.parents.push_back(path.parent);
        s.areas.push_back(path.area);
        s.is_closed.push_back(path.is_closed ? 1 : 0);
        for (const SectionEdge& edge : path.edges) s.sources.push_back(edge.source);
        if (!path.is_closed) s.sources.push_back(kNone);
    }
}

}  // namespace
}  // namespace kerf::c_api

using namespace kerf::c_api;

kerf_status kerf_section_find(const kerf_object* object, const kerf_plane* plane, const kerf_section_options* options,
                              kerf_section** section, char* reason, size_t reason_size)
{
    const Reason why(reason, reason_size);
    if (section == nullptr) return why.wrong("there is no place for the section");
    if (object == nullptr) return why.wrong("there is no object");
    const std::optional<kerf::Plane> by = read_plane(plane);
    if (!by) return why.wrong(kNoPlane);
    const std::optional<kerf_section_options> given = read_options(options);
    if (!given) return why.wrong(kWrongStruct);
    return with_memory(why, [&]() -> kerf_status {
        std::unique_ptr<kerf_section> made;
        if (*section == nullptr) made = std::make_unique<kerf_section>();
        kerf_section& found = made != nullptr ? *made : **section;
        const kerf::Status status = kerf::section(object->object, *by, found.section, to_options(*given));
        flatten(found);
        if (made != nullptr) *section = made.release();
        return why.answer(status, found.section.reason());
    });
}

kerf_status kerf_section_get_arrays(const kerf_section* section, kerf_section_arrays* arrays)
{
    if (section == nullptr) return KERF_INVALID_ARGUMENT;
    const kerf::Section& from = section->section;
    kerf_section_arrays to{};
    to.status = to_c(from.status);
    to.area = from.area;
    to.length = from.length;
    put(to.centroid, from.centroid);
    put(to.origin, from.frame.origin);
    put(to.x, from.frame.x);
    put(to.y, from.frame.y);
    to.path_count = section->parents.size();
    to.path_starts = section->path_starts.data();
    to.parents = section->parents.data();
    to.areas = section->areas.data();
    to.is_closed = section->is_closed.data();
    to.point_count = from.points().size();
    to.points = from.points().empty() ? nullptr : &from.points().data()->x;
    to.sources = section->sources.data();
    to.triangle_count = from.triangles().size() / 3;
    to.triangles = from.triangles().data();
    return fill_struct(arrays, to);
}
