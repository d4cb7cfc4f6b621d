#pragma once

#include <cstddef>
#include <span>

#include "common/cutting/cut_geometry.h"
#include "common/cutting/plane_section.h"
#include "common/mesh/indexed_mesh.h"

// The attributes along a section's outline. An edge has its own at both ends, so that seams stay sharp.

namespace kerf::core {

/// A place of a triangle: one of its corners, or the cut point of one of its edges.
struct PlaceInTriangle
{
    std::uint32_t a = 0, b = 0;  ///< vertices; of a corner both are it
    CutPoint cut;                ///< of the edge from a to b
    bool is_corner() const { return a == b; }
};

/// Where a point of the section lies in a triangle that its edge runs through: corners first, as split_triangle() does.
/// If neither a corner nor a cut point is there, bit for bit, the nearest corner.
PlaceInTriangle place_in_triangle(const Plane& plane, std::span<const Vertex> vertices, const Triangle& corners,
                                  const glm::vec3& position);

/// Adds the two ends of a section's next edge to PlaneSection::ends and ::end_streams, with the attributes that a cut
/// gives the vertices there. O(1 + floats of the streams). May throw std::bad_alloc.
///
/// @param corners  of the triangle that the edge runs through
/// @param streams  an array; each has `name`, `width`, and `values` for each vertex
template <class Streams>
void add_section_ends(const Plane& plane, std::span<const Vertex> vertices, const Streams& streams,
                      const Triangle& corners, const glm::vec3& from, const glm::vec3& to, PlaneSection& section)
{
    section.end_streams.resize(streams.size());
    for (const glm::vec3* position : {&from, &to}) {
        const PlaceInTriangle place = place_in_triangle(plane, vertices, corners, *position);
        const Vertex &a = vertices[place.a], &b = vertices[place.b];
        section.ends.push_back(place.is_corner() ? a : interpolate(place.cut, a, b));
        for (std::size_t s = 0; s < streams.size(); ++s) {
            const auto& stream = streams[s];
            PlaneSection::EndStream& ends = section.end_streams[s];
            if (ends.values.empty()) {
                ends.name = stream.name;
                ends.width = stream.width;
            }
            const std::size_t width = stream.width, first = ends.values.size();
            const float *of_a = &stream.values[place.a * width], *of_b = &stream.values[place.b * width];
            ends.values.insert(ends.values.end(), of_a, of_a + width);
            if (!place.is_corner()) interpolate(place.cut, of_a, of_b, &ends.values[first], stream.width);
        }
    }
}

}  // namespace kerf::core
