#pragma once

#include <cstdint>

#include "common/mesh/buffer.h"
#include "common/mesh/plane.h"
#include "linear/fragment.h"

namespace kerf::core::linear {

/// Where a vertex lies, as bits, so that the classes of a triangle's corners can be joined by "or".
enum : std::uint8_t
{
    kOn = 0,
    kBelow = 1,
    kAbove = 2,
    kCrossing = kBelow | kAbove
};

/// Where all vertices of a fragment lie.
struct VertexSides
{
    Buffer<std::uint8_t> of_vertex;
    std::uint32_t on = 0, far_below = 0, far_above = 0;  ///< on the plane; farther from it than the noise

    /// Classifies all vertices; `visit(vertex, class)` sees each of them. O(n).
    template <class Visit>
    void classify(const Fragment& whole, const Plane& plane, Visit&& visit)
    {
        const Buffer<Vertex>& vertices = whole.mesh.vertices;
        of_vertex.resize(vertices.size());
        std::uint8_t* const classes = of_vertex.data();
        const Plane local = plane;  // in registers: the loop writes through pointers that could alias the plane
        const double noise = whole.noise;
        std::uint32_t count_on = 0, count_far_below = 0, count_far_above = 0;
        const auto count = static_cast<std::uint32_t>(vertices.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const double d = local.signed_distance(vertices[i].position);
            const auto c = static_cast<std::uint8_t>(int(d < 0.0) | (int(d > 0.0) << 1));
            count_on += c == kOn;
            count_far_below += d < -noise;
            count_far_above += d > noise;
            classes[i] = c;
            visit(i, c);
        }
        // Centres of earlier fans do not count (rule 4): they are rounded means of a section and may stick out of the
        // surface by a last place.
        for (const std::uint32_t v : whole.fan_centres) {
            const double d = plane.signed_distance(vertices[v].position);
            count_far_below -= d < -noise;
            count_far_above -= d > noise;
        }
        on = count_on;
        far_below = count_far_below;
        far_above = count_far_above;
    }

    bool one_side_is_empty() const { return far_below == 0 || far_above == 0; }
};

}  // namespace kerf::core::linear
