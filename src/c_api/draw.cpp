#include <kerf/c.h>
#include <kerf/draw.h>

#include <memory>

#include "c_api/calls.h"
#include "c_api/handles.h"

using namespace kerf::c_api;

kerf_status kerf_object_draw(const kerf_object* object, kerf_draw** draw)
{
    if (object == nullptr || draw == nullptr) return KERF_INVALID_ARGUMENT;
    return with_memory(Reason(nullptr, 0), [&]() -> kerf_status {
        std::unique_ptr<kerf_draw> made;
        if (*draw == nullptr) made = std::make_unique<kerf_draw>();
        kerf_draw& filled = made != nullptr ? *made : **draw;
        filled.ranges.clear();
        const kerf::Status status = object->object.draw(filled.view);
        if (!ok(status)) return to_c(status);
        for (const kerf::DrawRange& r : filled.view.ranges)
            for (const uint32_t number :
                 {r.first_index, r.index_count, r.material, uint32_t(r.kind == kerf::TriangleKind::cap)})
                filled.ranges.push_back(number);
        if (made != nullptr) *draw = made.release();
        return KERF_DONE;
    });
}

kerf_status kerf_draw_get_arrays(const kerf_draw* draw, kerf_draw_arrays* arrays)
{
    if (draw == nullptr) return KERF_INVALID_ARGUMENT;
    const kerf::DrawView& from = draw->view;
    kerf_draw_arrays to{};
    to.buffers = from.buffers;
    to.vertex_count = from.vertices.size();
    to.index_count = from.indices.size();
    to.vertices = reinterpret_cast<const float*>(from.vertices.data());
    to.indices = from.indices.data();
    to.new_vertices_from = from.new_vertices_from;
    to.new_indices_from = from.new_indices_from;
    to.range_count = draw->ranges.size() / 4;
    to.ranges = draw->ranges.data();
    return fill_struct(arrays, to);
}

kerf_status kerf_object_mark_uploaded(kerf_object* object, const kerf_draw* draw)
{
    if (object == nullptr || draw == nullptr) return KERF_INVALID_ARGUMENT;
    object->object.mark_uploaded(draw->view);
    return KERF_DONE;
}
