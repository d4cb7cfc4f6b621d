#pragma once

#include <cmath>
#include <initializer_list>
#include <vector>

#include "common/repair/repair.h"

// Tiny named meshes, so that a test reads in one line. Positions only; normals are left to repair().

namespace kerf::core::small_meshes {

inline TriangleSoup soup(std::initializer_list<glm::vec3> positions, std::initializer_list<Triangle> triangles)
{
    TriangleSoup result;
    for (const glm::vec3& p : positions) result.vertices.push_back({p, glm::vec3(0.0f), glm::vec2(0.0f)});
    result.triangles.assign(triangles.begin(), triangles.end());
    result.has_normals = false;
    return result;
}

inline TriangleSoup tetrahedron()
{
    return soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

/// A cube from `corner` with side `size`: 8 vertices, 12 triangles.
inline TriangleSoup cube(const glm::vec3& corner = glm::vec3(0.0f), float size = 1.0f)
{
    TriangleSoup result;
    for (int i = 0; i < 8; ++i)
        result.vertices.push_back({corner + size * glm::vec3(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)),
                                   glm::vec3(0.0f), glm::vec2(0.0f)});
    result.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                        {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    result.has_normals = false;
    return result;
}

/// All triangles of both; vertices are not shared.
inline TriangleSoup operator+(TriangleSoup a, const TriangleSoup& b)
{
    const auto offset = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({i + offset, j + offset, k + offset});
    return a;
}

/// The same triangles, seen from the other side.
inline TriangleSoup inside_out(TriangleSoup mesh)
{
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// A grid of rows x columns quads whose points position(row, column) gives; where it closes, positions must be equal.
template <class Position>
TriangleSoup grid(std::uint32_t rows, std::uint32_t columns, Position&& position)
{
    TriangleSoup result;
    for (std::uint32_t i = 0; i <= rows; ++i)
        for (std::uint32_t j = 0; j <= columns; ++j)
            result.vertices.push_back({position(i, j), glm::vec3(0.0f), glm::vec2(0.0f)});
    for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j) {
            const std::uint32_t a = i * (columns + 1) + j, b = a + 1, c = a + columns + 1, d = c + 1;
            result.triangles.push_back({a, b, d});
            result.triangles.push_back({a, d, c});
        }
    result.has_normals = false;
    return result;
}

/// A strip with one half turn: `columns` quads around, one across.
inline TriangleSoup moebius_strip(std::uint32_t columns)
{
    return grid(1, columns, [&](std::uint32_t i, std::uint32_t j) {
        // The last column is the first one upside down, bit for bit.
        if (j == columns) i = 1 - i, j = 0;
        const double angle = 6.283185307179586 * j / columns, half = angle / 2, s = i - 0.5;
        return glm::vec3(std::cos(angle) * (2 + s * std::cos(half)), std::sin(angle) * (2 + s * std::cos(half)),
                         s * std::sin(half));
    });
}

/// A closed surface without inside and outside, in its usual immersion; rows x columns quads, rows even.
inline TriangleSoup klein_bottle(std::uint32_t rows, std::uint32_t columns)
{
    return grid(rows, columns, [&](std::uint32_t i, std::uint32_t j) {
        if (j == columns) j = 0, i = (rows + rows / 2 - i) % rows;
        i %= rows;
        // A figure eight that makes half a turn on its way around.
        const double u = 6.283185307179586 * j / columns, v = 6.283185307179586 * (i + 0.25) / rows;
        const double r = 3 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
        return glm::vec3(r * std::cos(u), r * std::sin(u),
                         std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v));
    });
}

}  // namespace kerf::core::small_meshes
