#include "viewer/sim/surface_hash.h"

#include <algorithm>
#include <array>
#include <new>

#include "viewer/sim/state_hash.h"

namespace kerf::sim {
namespace {

std::uint64_t vertex_hash(const DrawVertex& v)
{
    StateHash hash;
    for (const float number :
         {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.uv.x, v.uv.y})
        hash.add(number);
    return hash.value();
}

}  // namespace

std::uint64_t surface_hash(const Object& object)
{
    DrawView view;
    if (!ok(object.draw(view))) throw std::bad_alloc();
    std::uint64_t sum = 0;
    for (const DrawRange& range : view.ranges) {
        if (range.kind != TriangleKind::surface) continue;
        for (std::uint32_t i = range.first_index; i + 3 <= range.first_index + range.index_count; i += 3) {
            std::array<std::uint64_t, 3> corners;
            for (std::uint32_t c = 0; c < 3; ++c) corners[c] = vertex_hash(view.vertices[view.indices[i + c]]);
            // The same triangle whichever corner comes first; not the same when turned over.
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            StateHash triangle;
            triangle.add(range.material);
            for (const std::uint64_t corner : corners) triangle.add(corner);
            sum += triangle.value();
        }
    }
    return sum;
}

}  // namespace kerf::sim
