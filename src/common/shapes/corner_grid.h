#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <vector>

#include "common/mesh/triangle_soup.h"

// Building blocks of the generators. Positions are computed in double and rounded once; vertices that share a place get
// it from the same expression on the same numbers, so that they are equal bit for bit.

namespace kerf::core::shapes {

/// Throws std::length_error for a shape of more triangles than a mesh can have, before memory is taken for it.
inline void require_room(double triangles)
{
    constexpr double kMostCorners = 4294967296.0;
    if (!(3.0 * triangles <= kMostCorners)) throw std::length_error("a shape of more than 2^32 corners");
}

/// A vertex from numbers in double. -0 becomes +0; the normal need not have unit length.
inline Vertex make_vertex(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& uv)
{
    // Adding +0 turns -0 into +0 and leaves every other number alone.
    const glm::vec3 zero(0.0f);
    return {glm::vec3(position) + zero, glm::vec3(glm::normalize(normal)) + zero, glm::vec2(uv)};
}

/// Appends the triangles of `part` to `whole`; without materials and streams.
inline void append(TriangleSoup& whole, const TriangleSoup& part)
{
    const auto base = std::uint32_t(whole.vertices.size());
    whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Triangle& t : part.triangles) whole.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

/// Turns every triangle and normal over.
inline void turn_inside_out(TriangleSoup& soup)
{
    for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
    for (Vertex& v : soup.vertices) v.normal = glm::vec3(0.0f) - v.normal;
}

inline void translate(TriangleSoup& soup, const glm::vec3& by)
{
    for (Vertex& v : soup.vertices) v.position += by;
}

/// A rectangular grid of cells, two triangles each, added to a soup. Cells come in the order of a recursive bisection
/// of the longer side, so triangles that are close in the order are close on the surface; vertices are numbered by
/// first use. `make(i, j)` gives the vertex of a grid point; counter-clockwise from outside is (0,0) (1,0) (1,1) (0,1).
template <class MakeVertex>
class CornerGrid
{
public:
    CornerGrid(TriangleSoup& soup, std::uint32_t columns, std::uint32_t rows, MakeVertex make)
        : soup_(soup), columns_(columns), make_(make), index_(std::size_t(columns + 1) * (rows + 1), kUnused)
    {
        if (columns > 0 && rows > 0) fill(0, columns, 0, rows);
    }

private:
    static constexpr std::uint32_t kUnused = ~0u;

    void fill(std::uint32_t i0, std::uint32_t i1, std::uint32_t j0, std::uint32_t j1)
    {
        if (i1 - i0 == 1 && j1 - j0 == 1) {
            const std::uint32_t a = vertex(i0, j0), b = vertex(i1, j0), c = vertex(i1, j1), d = vertex(i0, j1);
            soup_.triangles.push_back({a, b, c});
            soup_.triangles.push_back({a, c, d});
        } else if (i1 - i0 >= j1 - j0) {
            const std::uint32_t middle = i0 + (i1 - i0) / 2;
            fill(i0, middle, j0, j1);
            fill(middle, i1, j0, j1);
        } else {
            const std::uint32_t middle = j0 + (j1 - j0) / 2;
            fill(i0, i1, j0, middle);
            fill(i0, i1, middle, j1);
        }
    }

    std::uint32_t vertex(std::uint32_t i, std::uint32_t j)
    {
        std::uint32_t& index = index_[std::size_t(j) * (columns_ + 1) + i];
        if (index == kUnused) {
            index = std::uint32_t(soup_.vertices.size());
            soup_.vertices.push_back(make_(i, j));
        }
        return index;
    }

    TriangleSoup& soup_;
    std::uint32_t columns_;
    MakeVertex make_;
    std::vector<std::uint32_t> index_;
};

/// A point on the surface of a box that is divided into cells.x * cells.y * cells.z cells.
struct BoxPoint
{
    glm::dvec3 cube;  ///< in [-1, 1]^3
    glm::dvec3 normal;
    glm::dvec2 face_uv;  ///< in [0, 1]^2 within its face
    int face = 0;        ///< 0 to 5: +x, -x, +y, -y, +z, -z
};

/// The six faces of a box as grids: 4 * (nx*ny + ny*nz + nz*nx) triangles. `make(BoxPoint)` gives the vertex; the three
/// coordinates in the cube depend on the lattice point only, so faces meet bit for bit.
template <class MakeVertex>
void add_box_grid(TriangleSoup& soup, glm::uvec3 cells, MakeVertex make)
{
    cells = glm::max(cells, glm::uvec3(1));
    const glm::dvec3 n(cells);
    require_room(4.0 * (n.x * n.y + n.y * n.z + n.z * n.x));
    const auto on_axis = [&](int axis, std::uint32_t i) { return 2.0 * double(i) / double(cells[axis]) - 1.0; };
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const bool plus = face % 2 == 0;
        // u x v points out of the plus face; the minus face swaps them.
        const int u = plus ? (axis + 1) % 3 : (axis + 2) % 3, v = plus ? (axis + 2) % 3 : (axis + 1) % 3;
        CornerGrid(soup, cells[u], cells[v], [&](std::uint32_t i, std::uint32_t j) {
            BoxPoint point{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec2(0.0), face};
            point.cube[axis] = point.normal[axis] = plus ? 1.0 : -1.0;
            point.cube[u] = on_axis(u, i);
            point.cube[v] = on_axis(v, j);
            point.face_uv = {double(i) / double(cells[u]), double(j) / double(cells[v])};
            return make(point);
        });
    }
}

}  // namespace kerf::core::shapes
