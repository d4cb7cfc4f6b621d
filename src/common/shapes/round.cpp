// Spheres, and the other shapes that a lathe makes.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/shapes/corner_grid.h"
#include "common/shapes/lathe.h"
#include "common/shapes/shapes.h"

namespace kerf::core::shapes {

TriangleSoup icosphere(float radius, std::uint32_t frequency)
{
    // The icosahedron with two corners on the z axis, as ten rhombi of two faces: five around the north pole that reach
    // to the lower ring, five around the south pole.
    std::array<glm::dvec3, 12> corner;
    const double height = 1.0 / std::sqrt(5.0), ring = 2.0 * height;
    corner[0] = {0, 0, 1};
    corner[11] = {0, 0, -1};
    for (int k = 0; k < 5; ++k) {
        const double upper = 0.4 * std::numbers::pi * k, lower = upper + 0.2 * std::numbers::pi;
        corner[std::size_t(k) + 1] = {ring * std::cos(upper), ring * std::sin(upper), height};
        corner[std::size_t(k) + 6] = {ring * std::cos(lower), ring * std::sin(lower), -height};
    }
    TriangleSoup soup;
    frequency = std::max(frequency, 1u);
    require_room(20.0 * double(frequency) * double(frequency));
    soup.vertices.reserve(std::size_t(10) * (frequency + 1) * (frequency + 1));
    soup.triangles.reserve(std::size_t(20) * frequency * frequency);
    // A rhombus a, b, c, d has the faces (a, b, c) and (a, c, d). Weights are whole numbers, so a point on an edge of
    // the icosahedron is the same sum of two terms in every rhombus that it belongs to.
    const auto add_rhombus = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d, const glm::dvec2& uv) {
        CornerGrid(soup, frequency, frequency, [&](std::uint32_t i, std::uint32_t j) {
            const double wa = double(frequency - std::max(i, j)), wc = double(std::min(i, j));
            const double wb = i > j ? double(i - j) : 0.0, wd = j > i ? double(j - i) : 0.0;
            const glm::dvec3 sum = i >= j ? wa * corner[a] + wb * corner[b] + wc * corner[c]
                                          : wa * corner[a] + wd * corner[d] + wc * corner[c];
            const glm::dvec3 unit = glm::normalize(sum);
            const glm::dvec2 cell = glm::dvec2(i, j) / double(frequency);
            return make_vertex(double(radius) * unit, unit, uv + cell * glm::dvec2(0.2, 0.5));
        });
    };
    for (std::size_t k = 0; k < 5; ++k) {
        const std::size_t next = (k + 1) % 5;
        add_rhombus(1 + k, 6 + k, 1 + next, 0, {0.2 * double(k), 0.5});
        add_rhombus(6 + k, 11, 6 + next, 1 + next, {0.2 * double(k), 0.0});
    }
    return soup;
}

TriangleSoup uv_sphere(float radius, std::uint32_t slices, std::uint32_t rings)
{
    ProfileRun run;
    rings = std::max(rings, 2u);
    require_room(6.0 * double(rings));
    for (std::uint32_t i = 0; i <= rings; ++i) {
        const double angle = std::numbers::pi * double(i) / double(rings);
        const bool pole = i == 0 || i == rings;
        const double r = pole ? 0.0 : std::sin(angle), z = i == 0 ? -1.0 : i == rings ? 1.0 : -std::cos(angle);
        run.push_back({double(radius) * r, double(radius) * z, r, z});
    }
    return turn({run}, slices);
}

TriangleSoup cylinder(float radius, float height, std::uint32_t slices, std::uint32_t stacks)
{
    const double r = double(radius), h = double(height) / 2.0;
    return turn({straight_run(0, -h, r, -h, 1), straight_run(r, -h, r, h, stacks), straight_run(r, h, 0, h, 1)},
                slices);
}

TriangleSoup cone(float radius, float height, std::uint32_t slices)
{
    const double r = double(radius), h = double(height) / 2.0;
    return turn({straight_run(0, -h, r, -h, 1), straight_run(r, -h, 0, h, 1)}, slices);
}

TriangleSoup torus(float major_radius, float minor_radius, std::uint32_t major, std::uint32_t minor)
{
    ProfileRun run;
    minor = std::max(minor, 3u);
    require_room(6.0 * double(minor));
    for (std::uint32_t i = 0; i <= minor; ++i) {
        const double angle = 2.0 * std::numbers::pi * double(i % minor) / double(minor);
        const double c = std::cos(angle), s = std::sin(angle);
        run.push_back({double(major_radius) + double(minor_radius) * c, double(minor_radius) * s, c, s});
    }
    return turn({run}, major);
}

TriangleSoup pipe(float outer_radius, float inner_radius, float height, std::uint32_t slices, std::uint32_t stacks)
{
    const double o = double(outer_radius), i = double(inner_radius), h = double(height) / 2.0;
    return turn({straight_run(o, -h, o, h, stacks), straight_run(o, h, i, h, 1), straight_run(i, h, i, -h, stacks),
                 straight_run(i, -h, o, -h, 1)},
                slices);
}

TriangleSoup bowl(float radius, float thickness, std::uint32_t slices, std::uint32_t rings)
{
    // Two half circles from the axis to the rim, the inner one back to the axis.
    ProfileRun outside, inside;
    rings = std::max(rings, 1u);
    require_room(12.0 * double(rings));
    const double outer = double(radius), inner = double(radius) - double(thickness);
    for (std::uint32_t i = 0; i <= rings; ++i) {
        const double angle = 0.5 * std::numbers::pi * double(i) / double(rings);
        const double r = i == 0 ? 0.0 : i == rings ? 1.0 : std::sin(angle), z = i == rings ? 0.0 : -std::cos(angle);
        outside.push_back({outer * r, outer * z, r, z});
        inside.insert(inside.begin(), {inner * r, inner * z, -r, -z});
    }
    return turn({outside, straight_run(outer, 0, inner, 0, 1), inside}, slices);
}

TriangleSoup nested_spheres(std::span<const float> radii, std::uint32_t frequency)
{
    TriangleSoup soup;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        TriangleSoup sphere = icosphere(radii[i], frequency);
        if (i % 2 == 1) turn_inside_out(sphere);
        append(soup, sphere);
    }
    return soup;
}

TriangleSoup sphere_in_sphere(float outer_radius, float inner_radius, std::uint32_t frequency)
{
    return nested_spheres(std::array{outer_radius, inner_radius}, frequency);
}

TriangleSoup overlapping_spheres(float radius, float distance, std::uint32_t frequency)
{
    TriangleSoup soup;
    for (const float x : {-0.5f * distance, 0.5f * distance}) {
        TriangleSoup sphere = icosphere(radius, frequency);
        translate(sphere, {x, 0.0f, 0.0f});
        append(soup, sphere);
    }
    return soup;
}

}  // namespace kerf::core::shapes
