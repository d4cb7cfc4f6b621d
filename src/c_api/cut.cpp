#include <kerf/c.h>

#include <memory>
#include <optional>
#include <utility>

#include "c_api/calls.h"
#include "c_api/handles.h"

namespace kerf::c_api {
namespace {

CutOptions to_options(const kerf_cut_options& given)
{
    CutOptions options;
    options.cap = given.leave_open == 0;
    options.components = given.components != 0;
    if (given.cap_material != 0) options.cap_material = given.cap_material - 1;
    if (given.cap_uv_scale != 0.0) options.cap_uv_scale = given.cap_uv_scale;
    options.gap = given.gap;
    if (given.delaunay != 0) options.cap_quality = CapQuality::delaunay;
    return options;
}

std::optional<Side> to_side(int32_t number)
{
    if (number == KERF_NEGATIVE) return Side::negative;
    if (number == KERF_POSITIVE) return Side::positive;
    return {};
}

}  // namespace
}  // namespace kerf::c_api

using namespace kerf::c_api;

kerf_status kerf_cut(kerf_object** object, const kerf_plane* plane, const kerf_cut_options* options,
                     kerf_pieces** pieces, char* reason, size_t reason_size)
{
    const Reason why(reason, reason_size);
    if (pieces == nullptr) return why.wrong("there is no place for the pieces");
    *pieces = nullptr;
    if (object == nullptr || *object == nullptr) return why.wrong("there is no object");
    const std::optional<kerf::Plane> by = read_plane(plane);
    if (!by) return why.wrong(kNoPlane);
    const std::optional<kerf_cut_options> given = read_options(options);
    if (!given) return why.wrong(kWrongStruct);
    return with_memory(why, [&]() -> kerf_status {
        auto made = std::make_unique<kerf_pieces>();
        made->cut = kerf::cut(std::move((*object)->object), *by, to_options(*given));
        kerf::Cut& cut = made->cut;
        const bool came_back = !cut.object.is_empty();
        if (came_back) {
            (*object)->object = std::move(cut.object);
        } else {
            kerf_free(*object);
            *object = nullptr;
        }
        // Out of memory in the second cut of a gap: pieces are there.
        if (!came_back || cut.status == kerf::Status::missed) *pieces = made.get();
        const kerf_status status = why.answer(cut.status, cut.reason());
        if (*pieces != nullptr) static_cast<void>(made.release());
        return status;
    });
}

kerf_status kerf_pieces_get_facts(const kerf_pieces* pieces, kerf_cut_facts* facts)
{
    if (pieces == nullptr) return KERF_INVALID_ARGUMENT;
    const kerf::Cut& cut = pieces->cut;
    const kerf::CutStatistics& cost = cut.statistics();
    kerf_cut_facts to{};
    to.status = to_c(cut.status);
    to.count[KERF_NEGATIVE] = cut.count(kerf::Side::negative);
    to.count[KERF_POSITIVE] = cut.count(kerf::Side::positive);
    to.section_area = cut.section_area;
    to.side_of_object = static_cast<int32_t>(cut.side_of_object);
    to.caps_exceed_section = cut.caps_exceed_section ? 1 : 0;
    to.crossing_triangles = cost.crossing_triangles;
    to.triangles_touched = cost.triangles_touched;
    to.section_loops = cost.section_loops;
    to.open_chains = cost.open_chains;
    to.milliseconds = cost.milliseconds();
    return fill_struct(facts, to);
}

kerf_object* kerf_pieces_take(kerf_pieces* pieces, int32_t side, size_t i)
{
    const std::optional<kerf::Side> of = to_side(side);
    if (pieces == nullptr || !of) return nullptr;
    kerf::Object* const piece = pieces->cut.piece(*of, i);
    if (piece == nullptr || piece->is_empty()) return nullptr;
    return new (std::nothrow) kerf_object(std::move(*piece));
}
